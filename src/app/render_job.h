// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/statistics.h"
#include "app/work_folder.h"
#include "app/worker_process.h"
#include "app/worker_protocol.h"

namespace poinsot::app {

/// One render, ready to run: everything was checked.
struct RenderRequest {
  SceneRequest scene;
  OutputTarget target;
  FrameRange frames;
  std::optional<double> time_s;  ///< of a still: film time in place of the frame's own
  int jobs = 1;                  ///< most worker processes
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = false;
  PictureForm form = {};
};

struct RenderSummary {
  Statistics spent;
  double wall_s = 0;
};

/// Called after every frame with how many are done and the time since the start.
using FrameListener = std::function<void(std::int64_t done, double elapsed_s)>;

/// CPUs this process may use.
int availableCpus();

/// Hands the segments of a film to worker processes and joins what they made. The bytes of the result do not
/// depend on how many there are. Opens no GL itself. A render that throws leaves no target and no work folder
/// behind (of a sequence the frames that were complete).
class RenderJob {
 public:
  /// @throws core::Error(kIo) if the work folder cannot be made.
  RenderJob(RenderRequest request, FrameListener listener);
  ~RenderJob();
  RenderJob(RenderJob&&) = delete;

  /// Runs to the end. Call once.
  /// @throws core::Error of a worker, or (kGraphics) if one died; Interrupted.
  RenderSummary run();

 private:
  void startWorkers();
  void awaitReports();
  void handle(WorkerProcess& worker, const WorkerReport& report);
  void handOut(WorkerProcess& worker);
  void publish() const;
  void stopWorkers();
  double elapsed_s() const;

  RenderRequest request_;
  FrameListener listener_;
  std::chrono::steady_clock::time_point start_;
  WorkFolder folder_;
  std::vector<FrameRange> segments_;
  std::deque<FrameRange> waiting_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;  // those still at work
  std::int64_t framesDone_ = 0;
  RenderSummary summary_;
};

}  // namespace poinsot::app
