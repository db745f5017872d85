// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "gl/offscreen_context.h"
#include "job/job_file.h"
#include "request/frame_plan.h"
#include "request/output_target.h"
#include "request/picture_form.h"
#include "request/scene_request.h"

namespace poinsot::job {

/// One render, ready to run: everything was checked.
struct RenderRequest {
  request::SceneRequest scene;
  request::OutputTarget target;
  request::FrameRange frames;
  std::optional<double> time_s;  ///< of a still: film time in place of the frame's own
  int jobs = 1;                  ///< most worker processes
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = false;
  request::PictureForm form = {};
  std::int64_t segmentFrames = request::kSegmentFrames;
  bool resume = false;                                 ///< what is there and is the same is not made again
  bool keepWork = false;                               ///< leaves the segments when all is done
  std::optional<request::Shard> shard = {};            ///< only its segments, and no film of them
  std::optional<std::filesystem::path> manifest = {};  ///< of a film or a sequence
  std::optional<std::filesystem::path> trace = {};     ///< TraceFile of it
  std::optional<JobFile> job = {};                     ///< jobFileOf() this, of a film and a sequence
  bool digestsPixels = false;  ///< of a still: whether the worker reports the pixelDigest()
  double worker_bytes = 0;     ///< that a worker is estimated to take (memory.h), for messages

  /// Returns the segments that this render makes: all, or its shard's.
  std::vector<request::FrameRange> segments() const {
    return request::segmentsOf(shard.value_or(request::Shard()), request::segmentsOf(frames, segmentFrames));
  }
};

}  // namespace poinsot::job
