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

/// Makes the sink of one segment.
using SinkMaker = std::function<std::unique_ptr<output::FrameSink>(const request::FrameRange& segment)>;

/// What a worker knows of the segments of its render, whoever made them, and tells of its own.
class SegmentKeeper {
 public:
  /// `renderer`: GL_RENDERER of this process.
  SegmentKeeper(const WorkerTask& task, std::string renderer);

  /// Whether the segment is there, as it would be made now: by the same job, or by another of the same pictures.
  bool has(const request::FrameRange& segment, FrameSource& source) const;
  /// Takes down that the segment is complete. @throws core::Error(kIo).
  void keep(const request::FrameRange& segment, std::vector<std::string> digests) const;

 private:
  request::OutputTarget target_;
  std::filesystem::path workFolder_;
  SegmentRecords records_;
  bool resume_;
  std::string jobDigest_, renderer_;
};

/// Makes segments as they come in, one after the other, and reports each frame and segment, until no more come.
/// Those that the keeper has, and frames that a sink has, are not made again; without a keeper nothing is taken
/// down. With `digestsPixels` each report of a frame has its pixelDigest(). `steps` is what the source and the
/// sinks enter their time into; its spans are reported as they come.
/// @throws core::Error of the source or a sink; Interrupted.
Statistics makeSegments(process::LineReader& segments, int reports, FrameSource& source, const SinkMaker& sinkOf,
                        core::StepLedger& steps, const SegmentKeeper* keeper = nullptr,
                        bool digestsPixels = false);

/// The life of a worker process: reads segments from `segments`, reports to `reports`. Opens the one GL context of
/// this process.
/// @returns the exit status; a failure was reported before it returns.
int runWorker(const WorkerTask& task, int segments, int reports);

}  // namespace poinsot::job
