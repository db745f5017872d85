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

/// Callback after every frame, with the number of frames done, how many of these existed already, and the wall
/// time since the start.
using FrameListener = std::function<void(std::int64_t done, std::int64_t reused, double elapsed_s)>;

/// Returns the number of CPUs that this process may use, at least 1.
int availableCpus();

/// Render that hands segments to worker processes and joins the results. The number of workers does not change a
/// byte of the output. The job itself opens no OpenGL context. If the render throws, the target is not written,
/// and the completed segments stay for a later render to resume.
class RenderJob {
 public:
  /// @throws core::Error(kIo) if the work folder cannot be made.
  RenderJob(RenderRequest request, FrameListener listener);
  ~RenderJob();
  RenderJob(RenderJob&&) = delete;

  /// Runs the whole render: begin(), takeReports() until no worker is left, and end().
  /// @throws core::Error from a worker; core::Error(kGraphics) if a worker died; Interrupted
  RenderSummary run();

  /// Starts the workers, unless the target is already finished.
  void begin();
  /// Returns whether a worker may still send reports.
  bool isMaking() const { return !workers_.empty(); }
  /// Handles the reports that have arrived, without waiting for more.
  void takeReports();
  /// Joins the segments and gives all output files their final names together.
  RenderSummary end();
  /// Signals the workers to stop, without waiting; the destructor waits. A caller with several jobs can thus stop
  /// all of them at once.
  void askToStop();

  /// Returns the number of frames in completed segments, which a later render can reuse; 0 for a still or a
  /// stream.
  std::int64_t framesKept() const;

 private:
  friend void awaitReports(const std::vector<const RenderJob*>& jobs);

  output::FilmState stateBefore() const;
  bool isFinished() const { return found_ == output::FilmState::kWhole; }
  /// Runs `work` and records its time in the trace, as work of this process.
  void traced(const char* name, const std::function<void()>& work);
  void startWorkers();
  void watch(std::vector<pollfd>& watched) const;
  void handle(WorkerProcess& worker, const WorkerReport& report);
  void sendOn(const request::FrameRange& segment);
  void handOut(WorkerProcess& worker);
  void countWritten(const request::FrameRange& segment);
  void gather(core::FileBatch& results);
  void gatherStill(core::FileBatch& results) const;
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
