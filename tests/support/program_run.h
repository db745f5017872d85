// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/scratch_folder.h"

namespace poinsot {

struct RunResult {
  int exitCode = -1;  ///< 1000 + signal number if a signal killed the program, which should not happen
  std::string out, err;
};

/// Target of the program's stdout. kUnread is a pipe whose reader never reads.
enum class Stdout { kFile, kClosed, kBrokenPipe, kUnread, kFull };

/// Process of the built program, in a process group of its own and in a scratch folder.
class ProgramRun {
 public:
  /// Starts the program.
  /// @param folder  working folder; also keeps stdout and stderr under hidden names
  /// @param environment  entries "NAME=value", added to this process's own environment
  ProgramRun(const ScratchFolder& folder, const std::vector<std::string>& arguments,
             Stdout stdoutTo = Stdout::kFile, const std::vector<std::string>& environment = {});
  /// Kills the process group if the process still runs.
  ~ProgramRun();
  ProgramRun(const ProgramRun&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) const;
  std::string errSoFar() const;
  RunResult wait();

 private:
  std::filesystem::path out_, err_;
  pid_t pid_ = -1;
};

/// Starts the program and waits for its end.
RunResult run(const ScratchFolder& folder, const std::vector<std::string>& arguments,
              Stdout stdoutTo = Stdout::kFile, const std::vector<std::string>& environment = {});

/// Returns all bytes of a file; fails the test if the file cannot be read.
std::string bytesOf(const std::filesystem::path& file);

/// Returns the sorted names in a folder, without the hidden files of the harness.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

/// Valid scene of 4 s at 30 fps, 160 x 90 pixels.
extern const char* const kGoodScene;

}  // namespace poinsot
