// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "core/file_handle.h"
#include "job/render_request.h"
#include "job/worker_protocol.h"
#include "process/line_channel.h"
#include "request/frame_plan.h"

namespace poinsot::job {

/// A worker: a fork of this process, in the same process group, ended with its parent. Nothing is executed, so
/// that it works where that is forbidden (sandbox.h). Destroying one that still runs kills it.
class WorkerProcess {
 public:
  /// @param number  to tell it from others of the same task
  /// @warning Forks: this process must have one thread, and must never have opened a context, because Mesa's
  /// threads are not forked with it.
  /// @throws core::Error(kGraphics) if no process can be started.
  WorkerProcess(const WorkerTask& task, int number);
  ~WorkerProcess();
  WorkerProcess(WorkerProcess&&) = delete;

  /// Hands it a segment, or says that there are no more. A worker that is gone is noticed through its reports.
  /// @throws core::Error(kGraphics) if the message cannot be sent.
  void give(const request::FrameRange& segment);
  void giveNoMore();
  const std::optional<request::FrameRange>& segment() const { return segment_; }

  int number() const { return number_; }

  /// For poll(): readable when a report came, or the end.
  int reportsFd() const { return reports_.get(); }
  /// Reads what is there; false when the worker closed its end.
  bool readReports() { return reader_.fill(); }
  std::optional<WorkerReport> takeReport();
  /// Whether it reported its end, as told by setFinished().
  bool finished() const { return finished_; }
  void setFinished() { finished_ = true; }

  /// Asks it to clean up and end.
  void askToStop();
  /// Whether it ended; waits up to `wait_s` for that. @returns in words how, once it has.
  std::optional<std::string> ended(double wait_s);
  /// The same without a word, for those who cannot fail.
  void awaitEnd(double wait_s) noexcept;
  void kill();

 private:
  void tell(const std::string& line) const;

  int number_;
  pid_t pid_ = -1;
  int status_ = 0;  ///< as waitpid has it, once pid_ is none
  core::FileHandle segments_, reports_;
  process::LineReader reader_{-1};
  std::optional<request::FrameRange> segment_;
  bool finished_ = false;
};

}  // namespace poinsot::job
