// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

/// Films made by the scripts that `submit` prints.
namespace poinsot::faults {

/// Wall time since it was made.
class Watch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The tiny film, of six segments, in a folder whose name is as bad as a name can be for a script; a program
/// besides in place of poinsot whose render of one shard is killed.
class SubmittedFilm {
 public:
  static constexpr int kTasks = 3;

  /// Of the characters of a name GNU make cannot hold %.
  static constexpr const char* kFolder = "a film's $HOME {} {1} #1 \"100%A\" `x`=\u00e9";
  static constexpr const char* kFolderForMake = "a film's $HOME {} #1 \"100\" `x`=\u00e9: *?[y]";

  explicit SubmittedFilm(const std::string& folder = kFolder);

  /// Writes a file of the folder.
  void put(const std::string& name, const std::string& text) const;

  /// Prints the script of an engine. @param more  options of submit
  void writeScript(const std::string& engine, const std::string& more = "") const;

  /// Runs commands in the folder; the script is "$script" in them, the program $poinsot, the film film.mp4.
  ShellResult shell(const std::string& commands, const std::vector<std::string>& environment = {}) const;

  /// From now on the render of that shard dies by SIGKILL, all its processes: once, while it makes its second
  /// segment, or always, with its first.
  void breakShard(int k, bool onlyOnce) const;
  /// The next joining fails.
  void breakJoining() const;
  /// From now on that shard's program stands still, once, as on a node that is lost; died() once it does.
  void hangShard(int k) const;
  void repair() const;
  /// Whether one died or stands still since the last call of breakShard() or hangShard().
  bool died() const;
  bool waitUntilDied(double most_s) const;
  /// Lets a script run the program that dies.
  std::vector<std::string> broken() const;

  bool hasFilm() const;
  /// The oracle: what one process makes of it here, told --reproducible. @param said  told when it differs
  void expectTheBytesOfALocalRun(const std::string& said);
  /// How long that took.
  double local_s() const { return local_s_; }

 private:
  std::string localFilm();

  ScratchFolder scratch_;
  std::filesystem::path folder_;
  double local_s_ = 0;
};

}  // namespace poinsot::faults
