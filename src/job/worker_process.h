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

/// Worker process, started by fork(). It is in the same process group, and is killed if its parent ends. A worker
/// executes no other program, and its sandbox forbids that (sandbox.h). The destructor kills a running worker.
class WorkerProcess {
 public:
  /// @param number  number of the worker in its task
  /// @warning Forks: this process must have one thread and must never have opened an OpenGL context, because a
  /// fork has no copies of Mesa's threads.
  /// @throws core::Error(kGraphics) if no process can be started.
  WorkerProcess(const WorkerTask& task, int number);
  ~WorkerProcess();
  WorkerProcess(WorkerProcess&&) = delete;

  /// Sends a segment to the worker. If the worker has ended, does nothing; readReports() detects that.
  /// @throws core::Error(kGraphics) if the message cannot be sent.
  void give(const request::FrameRange& segment);
  void giveNoMore();
  const std::optional<request::FrameRange>& segment() const { return segment_; }

  int number() const { return number_; }

  /// Returns the descriptor for poll(). It is readable if a report has arrived, and at the end of all reports.
  int reportsFd() const { return reports_.get(); }
  /// Reads available reports, or waits for one. Returns false if the worker has closed its end of the pipe.
  bool readReports() { return reader_.fill(); }
  std::optional<WorkerReport> takeReport();
  /// Returns whether the worker has reported its end, as recorded by setFinished().
  bool finished() const { return finished_; }
  void setFinished() { finished_ = true; }

  /// Sends SIGTERM to the worker, which then cleans up and ends.
  void askToStop();
  /// Waits up to `wait_s` seconds for the end of the worker.
  /// @returns a phrase on how the worker ended; nullopt if it is still running
  std::optional<std::string> ended(double wait_s);
  /// Waits up to `wait_s` seconds for the end of the worker. Unlike ended(), never throws.
  void awaitEnd(double wait_s) noexcept;
  void kill();

 private:
  void tell(const std::string& line) const;

  int number_;
  pid_t pid_ = -1;
  int status_ = 0;  ///< status from waitpid(); valid if pid_ is -1
  core::FileHandle segments_, reports_;
  process::LineReader reader_{-1};
  std::optional<request::FrameRange> segment_;
  bool finished_ = false;
};

}  // namespace poinsot::job
