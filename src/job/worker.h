// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "job/frame_source.h"
#include "job/render_request.h"
#include "job/segment_record.h"
#include "job/statistics.h"
#include "output/frame_sink.h"
#include "process/line_channel.h"
#include "request/frame_plan.h"

namespace poinsot::job {

using SinkMaker = std::function<std::unique_ptr<output::FrameSink>(const request::FrameRange& segment)>;

/// Detects segments that a worker can reuse, and records the segments that the worker completes.
class SegmentKeeper {
 public:
  SegmentKeeper(const WorkerTask& task, std::string renderer);

  /// Returns whether a finished segment can be reused. The segment must have been made by the same job and
  /// renderer, or have the same frame digests. In the latter case, assigns the segment's record to this job.
  bool has(const request::FrameRange& segment, FrameSource& source) const;
  /// Records a completed segment. @throws core::Error(kIo).
  void keep(const request::FrameRange& segment, std::vector<std::string> digests) const;

 private:
  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  SegmentRecords records_;
  bool resume_;
  std::string jobDigest_, renderer_;
};

/// Makes the segments that arrive from the main process, and reports each frame and segment. Returns when the main
/// process sends no more. Reuses segments that `keeper` finds and frames that a sink already has.
/// @param steps  ledger of the source and the sinks; its spans are reported
/// @param keeper  null if segments are neither reused nor recorded
/// @param digestsPixels  adds the pixelDigest() to the report of each frame
/// @throws core::Error of the source or a sink; Interrupted.
Statistics makeSegments(process::LineReader& segments, int reports, FrameSource& source, const SinkMaker& sinkOf,
                        core::StepLedger& steps, const SegmentKeeper* keeper = nullptr,
                        bool digestsPixels = false);

/// Runs a worker process. Reads segments from the descriptor `segments`, and writes reports to `reports`. Opens
/// the only OpenGL context of this process.
/// @returns the exit status; any error has already been reported
int runWorker(const WorkerTask& task, int segments, int reports);

}  // namespace poinsot::job
