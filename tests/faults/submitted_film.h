// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot::faults {

class Watch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Tiny film of six segments, in a folder whose name is as difficult as possible for a script. Beside it is a
/// stand-in for poinsot whose render of one shard can be killed.
class SubmittedFilm {
 public:
  static constexpr int kTasks = 3;

  /// Names with difficult characters. GNU make cannot handle % in a name.
  static constexpr const char* kFolder = "a film's $HOME {} {1} #1 \"100%A\" `x`=\u00e9";
  static constexpr const char* kFolderForMake = "a film's $HOME {} #1 \"100\" `x`=\u00e9: *?[y]";

  explicit SubmittedFilm(const std::string& folder = kFolder);

  void put(const std::string& name, const std::string& text) const;

  /// Writes the script that `submit` prints for an engine. @param more  options of submit
  void writeScript(const std::string& engine, const std::string& more = "") const;

  /// Runs commands in the folder. They can use "$script" for the script and $poinsot for the program; the film is
  /// film.mp4.
  ShellResult shell(const std::string& commands, const std::vector<std::string>& environment = {}) const;

  /// Makes SIGKILL end all processes of that shard's render from now on: once, in its second segment, or always,
  /// in its first.
  void breakShard(int k, bool onlyOnce) const;
  void breakJoining() const;
  /// Makes that shard's program hang once, as on a lost node; died() then returns true.
  void hangShard(int k) const;
  void repair() const;
  /// Returns whether a program has died or hangs since the last call of breakShard() or hangShard().
  bool died() const;
  bool waitUntilDied(double most_s) const;
  /// Returns the path of the stand-in.
  std::string standIn() const { return scratch_ / "dying"; }
  /// Returns variables with which a script runs the stand-in.
  std::vector<std::string> broken() const { return {"POINSOT=" + standIn()}; }

  bool hasFilm() const;
  /// Compares the film with its oracle, which one local process makes with --reproducible.
  /// @param said  printed if the bytes differ
  void expectTheBytesOfALocalRun(const std::string& said);
  double local_s() const { return local_s_; }

 private:
  std::string localFilm();

  ScratchFolder scratch_;
  std::filesystem::path folder_;
  double local_s_ = 0;
};

}  // namespace poinsot::faults
