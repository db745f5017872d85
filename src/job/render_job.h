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

/// Callback after every frame. Receives the number of frames that are done, how many of them existed before the
/// render, and the wall time since the start.
using FrameListener = std::function<void(std::int64_t done, std::int64_t reused, double elapsed_s)>;

/// Returns the number of CPUs that this process may use, at least 1.
int availableCpus();

/// Render that distributes segments to worker processes and joins the results. The output does not depend on the
/// number of workers. The main process opens no OpenGL context. If the render throws, the target is not written.
/// The completed segments stay, so that a later render can resume.
class RenderJob {
 public:
  /// @throws core::Error(kIo) if the work folder cannot be created.
  RenderJob(RenderRequest request, FrameListener listener);
  ~RenderJob();
  RenderJob(RenderJob&&) = delete;

  /// Runs the complete render: begin(), then takeReports() until all workers have finished, then end().
  /// @throws core::Error from a worker; core::Error(kGraphics) if a worker died; Interrupted
  RenderSummary run();

  /// Starts the workers, unless the target is already finished.
  void begin();
  /// Returns whether workers are still running and may send reports.
  bool isMaking() const { return !workers_.empty(); }
  /// Handles the reports that have arrived, without waiting for more.
  void takeReports();
  /// Joins the segments, and renames all output files to their final names together. If RenderChoices::accepted
  /// does not contain the film's size, removes all files instead.
  RenderSummary end();
  /// Sends a signal to stop to all workers, without waiting. The destructor waits. A caller with several jobs can
  /// thus stop all jobs at the same time.
  void askToStop();

  /// Returns the number of frames that a later render can reuse. Returns 0 for a still, a stream, or a film whose
  /// size is limited.
  std::int64_t framesKept() const;

 private:
  friend void awaitReports(const std::vector<const RenderJob*>& jobs);

  output::FilmState stateBefore() const;
  bool isFinished() const { return found_ == output::FilmState::kWhole; }
  /// Runs `work` and records its duration in the trace, under the number of the main process.
  void traced(const char* name, const std::function<void()>& work);
  void startWorkers();
  void watch(std::vector<pollfd>& watched) const;
  void handle(WorkerProcess& worker, const WorkerReport& report);
  void sendOn(const request::FrameRange& segment);
  void handOut(WorkerProcess& worker);
  void countWritten(const request::FrameRange& segment);
  void gather(core::FileBatch& results);
  void gatherStill(core::FileBatch& results) const;
  bool isAccepted(const core::FileBatch& results);
  void addManifest(core::FileBatch& results) const;
  static void addAbout(core::FileBatch& results, core::AtomicFile file);
  void removeOldManifest() const;
  void stopWorkers();
  double elapsed_s() const;

  RenderRequest request_;
  output::FilmState found_ = output::FilmState::kOther;  ///< state of the target before the render
  FrameListener listener_;
  std::chrono::steady_clock::time_point start_;
  WorkFolder folder_;
  std::optional<TraceFile> trace_;
  std::optional<SegmentStream> stream_;
  std::vector<request::FrameRange> segments_;
  std::deque<request::FrameRange> waiting_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::int64_t framesDone_ = 0;
  std::int64_t segmentFramesDone_ = 0;
  double written_bytes_ = 0;
  RenderSummary summary_;
};

/// Waits until a worker of one of the jobs sends a report. @throws Interrupted
void awaitReports(const std::vector<const RenderJob*>& jobs);

}  // namespace poinsot::job
