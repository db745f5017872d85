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

/// Finds segments that a worker can reuse, and records the segments that the worker completes.
class SegmentKeeper {
 public:
  SegmentKeeper(const WorkerTask& task, std::string renderer);

  /// Returns whether a finished segment can be reused. The segment must come from the same job and renderer, or
  /// show the same pictures; in the second case its record is updated to this job.
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

/// Makes the segments that arrive from the parent until no more come, and reports each frame and segment. Reuses
/// the segments that the keeper has and the frames that a sink has.
/// @param steps  ledger of the source and the sinks, whose spans are reported
/// @param keeper  null if segments are neither reused nor recorded
/// @param digestsPixels  adds the pixelDigest() to the report of each frame
/// @throws core::Error of the source or a sink; Interrupted.
Statistics makeSegments(process::LineReader& segments, int reports, FrameSource& source, const SinkMaker& sinkOf,
                        core::StepLedger& steps, const SegmentKeeper* keeper = nullptr,
                        bool digestsPixels = false);

/// Runs a worker process: reads segments from the descriptor `segments`, and writes reports to `reports`. Opens
/// the only OpenGL context of this process.
/// @returns the exit status; an error has been reported before the function returns
int runWorker(const WorkerTask& task, int segments, int reports);

}  // namespace poinsot::job
