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

/// Worker process: a fork of this process, in the same process group, killed if its parent ends. A worker executes
/// no program, so it works in a sandbox that forbids this (sandbox.h). Destroying a running worker kills it.
class WorkerProcess {
 public:
  /// @param number  distinguishes the workers of a task
  /// @warning Forks: this process must have one thread and must never have opened an OpenGL context, because a
  /// fork lacks Mesa's threads.
  /// @throws core::Error(kGraphics) if no process can be started.
  WorkerProcess(const WorkerTask& task, int number);
  ~WorkerProcess();
  WorkerProcess(WorkerProcess&&) = delete;

  /// Sends a segment to the worker. Does not fail if the worker is gone, which readReports() detects.
  /// @throws core::Error(kGraphics) if the message cannot be sent.
  void give(const request::FrameRange& segment);
  void giveNoMore();
  const std::optional<request::FrameRange>& segment() const { return segment_; }

  int number() const { return number_; }

  /// Returns the descriptor to poll(), which is readable after a report or at the end of the reports.
  int reportsFd() const { return reports_.get(); }
  /// Reads once, waiting if no report is there. Returns false if the worker closed its end.
  bool readReports() { return reader_.fill(); }
  std::optional<WorkerReport> takeReport();
  /// Returns whether setFinished() was called, after the worker reported its end.
  bool finished() const { return finished_; }
  void setFinished() { finished_ = true; }

  /// Sends SIGTERM, so that the worker cleans up and ends.
  void askToStop();
  /// Waits up to `wait_s` seconds for the end of the worker.
  /// @returns how the worker ended, in words; nullopt if it still runs
  std::optional<std::string> ended(double wait_s);
  /// Waits like ended(), without a result, for callers that must not throw.
  void awaitEnd(double wait_s) noexcept;
  void kill();

 private:
  void tell(const std::string& line) const;

  int number_;
  pid_t pid_ = -1;
  int status_ = 0;  ///< from waitpid(); valid once pid_ is -1
  core::FileHandle segments_, reports_;
  process::LineReader reader_{-1};
  std::optional<request::FrameRange> segment_;
  bool finished_ = false;
};

}  // namespace poinsot::job
