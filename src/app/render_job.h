// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "app/render_request.h"
#include "app/render_summary.h"
#include "app/segment_stream.h"
#include "app/trace_file.h"
#include "app/work_folder.h"
#include "app/worker_process.h"
#include "app/worker_protocol.h"

namespace poinsot::app {

/// Called after every frame with how many are done, how many of them were there already, and the time since the
/// start.
using FrameListener = std::function<void(std::int64_t done, std::int64_t reused, double elapsed_s)>;

/// CPUs this process may use.
int availableCpus();

/// Hands the segments of a film to worker processes and joins what they made. The bytes of the result do not
/// depend on how many there are. Opens no GL itself. A render that throws leaves no target behind, and of its work
/// the segments that were complete, for another to go on with.
class RenderJob {
 public:
  /// @throws core::Error(kIo) if the work folder cannot be made.
  RenderJob(RenderRequest request, FrameListener listener);
  ~RenderJob();
  RenderJob(RenderJob&&) = delete;

  /// Runs to the end. Call once.
  /// @throws core::Error of a worker, or (kGraphics) if one died; Interrupted.
  RenderSummary run();

  /// Frames of the segments that are complete, for another render to go on with. None of a still.
  std::int64_t framesKept() const;

 private:
  bool isFinished() const;
  void make();
  /// Calls it, and puts it into the trace as work of this process.
  void traced(const char* name, const std::function<void()>& work);
  void startWorkers();
  void awaitReports();
  void handle(WorkerProcess& worker, const WorkerReport& report);
  void sendOn(const FrameRange& segment);
  void handOut(WorkerProcess& worker);
  void publish();
  void stopWorkers();
  double elapsed_s() const;

  RenderRequest request_;
  FrameListener listener_;
  std::chrono::steady_clock::time_point start_;
  WorkFolder folder_;
  std::optional<TraceFile> trace_;
  std::optional<SegmentStream> stream_;  ///< where the target is one
  std::vector<FrameRange> segments_;
  std::deque<FrameRange> waiting_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;  // those still at work
  std::int64_t framesDone_ = 0;
  std::int64_t segmentFramesDone_ = 0;  // of whole segments
  RenderSummary summary_;
};

}  // namespace poinsot::app
