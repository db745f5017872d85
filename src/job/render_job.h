// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <poll.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "core/file_batch.h"
#include "job/render_request.h"
#include "job/segment_stream.h"
#include "job/statistics.h"
#include "job/trace_file.h"
#include "job/work_folder.h"
#include "job/worker_process.h"
#include "job/worker_protocol.h"

namespace poinsot::job {

/// Called after every frame with how many are done, how many of them were there already, and the time since the
/// start.
using FrameListener = std::function<void(std::int64_t done, std::int64_t reused, double elapsed_s)>;

/// CPUs this process may use.
int availableCpus();

/// Hands the segments of a film to worker processes and joins what they made. The bytes of the result do not
/// depend on how many there are. Opens no context itself. A render that throws leaves no target behind, and of its
/// work the segments that were complete, for another to go on with.
class RenderJob {
 public:
  /// @throws core::Error(kIo) if the work folder cannot be made.
  RenderJob(RenderRequest request, FrameListener listener);
  ~RenderJob();
  RenderJob(RenderJob&&) = delete;

  /// Runs to the end: begin(), takeReports() until none is to come, end().
  /// @throws core::Error of a worker, or (kGraphics) if one died; Interrupted.
  RenderSummary run();

  /// Starts the workers.
  void begin();
  /// Whether a worker still has something to report.
  bool isMaking() const { return !workers_.empty(); }
  /// Reads what has been reported, without waiting for more.
  void takeReports();
  /// Gives all results their names, together.
  RenderSummary end();
  /// Asks the workers to stop, for whoever has other jobs to stop as well: the destructor waits for them.
  void askToStop();

  /// Frames of the segments that are complete, for another render to go on with. None of a still.
  std::int64_t framesKept() const;

 private:
  friend void awaitReports(const std::vector<const RenderJob*>& jobs);

  output::FilmState stateBefore() const;
  bool isFinished() const { return found_ == output::FilmState::kWhole; }
  /// Calls it, and puts it into the trace as work of this process.
  void traced(const char* name, const std::function<void()>& work);
  void startWorkers();
  void watch(std::vector<pollfd>& watched) const;
  void handle(WorkerProcess& worker, const WorkerReport& report);
  void sendOn(const request::FrameRange& segment);
  void handOut(WorkerProcess& worker);
  void countWritten(const request::FrameRange& segment);
  /// Adds what the workers made, complete.
  void gather(core::FileBatch& results);
  void gatherStill(core::FileBatch& results) const;
  void addManifest(core::FileBatch& results) const;
  static void addAbout(core::FileBatch& results, core::AtomicFile file);
  void removeOldManifest() const;
  void stopWorkers();
  double elapsed_s() const;

  RenderRequest request_;
  output::FilmState found_ = output::FilmState::kOther;  ///< before it began
  FrameListener listener_;
  std::chrono::steady_clock::time_point start_;
  WorkFolder folder_;
  std::optional<TraceFile> trace_;
  std::optional<SegmentStream> stream_;  ///< where the target is one
  std::vector<request::FrameRange> segments_;
  std::deque<request::FrameRange> waiting_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;  // those still at work
  std::int64_t framesDone_ = 0;
  std::int64_t segmentFramesDone_ = 0;  // of whole segments
  double written_bytes_ = 0;            // by them
  RenderSummary summary_;
};

/// Waits until a worker of one of these has something to report. @throws Interrupted
void awaitReports(const std::vector<const RenderJob*>& jobs);

}  // namespace poinsot::job
