// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/file_handle.h"

namespace poinsot::preview {

/// Run of `poinsot` in a separate process, so that a failure of the run does not end the preview. Standard input
/// and output of the process are /dev/null. The destructor ends the run.
class ProgramRun {
 public:
  /// @param words  arguments for poinsot
  /// @throws core::Error(kGraphics) if no process can be started.
  explicit ProgramRun(const std::vector<std::string>& words);
  ~ProgramRun();
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;

  /// Waits for the end of the process. @param take  receives each line that the process prints on standard error
  /// @returns whether the process exited with 0. @pre called at most once.
  bool wait(const std::function<void(const std::string& line)>& take);
  /// Sends SIGINT to the process, as Ctrl-C does. Any thread may call this function.
  void interrupt();

 private:
  core::FileHandle errors_;
  std::mutex mutex_;
  pid_t process_ = -1;  // -1 after the end, because the system may use the process ID again
};

}  // namespace poinsot::preview
