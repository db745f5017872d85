// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/scratch_folder.h"

namespace poinsot {

/// What became of a run.
struct RunResult {
  int exitCode = -1;  ///< 1000 + signal if a signal killed it: no run should end that way
  std::string out, err;
};

/// Where the program's stdout leads: kUnread is a pipe whose reader never reads.
enum class Stdout { kFile, kClosed, kBrokenPipe, kUnread, kFull };

/// The built program as a process of its own group, in a folder of its own.
class ProgramRun {
 public:
  /// Starts it. @param folder  working folder; stdout and stderr are kept in it under hidden names.
  /// `environment`: "NAME=value", on top of this process's own.
  ProgramRun(const ScratchFolder& folder, const std::vector<std::string>& arguments,
             Stdout stdoutTo = Stdout::kFile, const std::vector<std::string>& environment = {});
  /// Kills it if it still runs.
  ~ProgramRun();
  ProgramRun(const ProgramRun&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) const;
  /// What it wrote to stderr so far.
  std::string errSoFar() const;
  /// Waits for its end.
  RunResult wait();

 private:
  std::filesystem::path out_, err_;
  pid_t pid_ = -1;
};

/// Runs it to the end.
RunResult run(const ScratchFolder& folder, const std::vector<std::string>& arguments,
              Stdout stdoutTo = Stdout::kFile, const std::vector<std::string>& environment = {});

/// All bytes of a file; fails the test if it cannot be read.
std::string bytesOf(const std::filesystem::path& file);

/// Names in a folder that are not the harness's own, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

/// A good scene of 4 s at 30 fps, 160x90.
extern const char* const kGoodScene;

}  // namespace poinsot
