// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "app/frame_plan.h"
#include "app/job_file.h"
#include "app/output_target.h"
#include "app/picture_form.h"
#include "app/scene_request.h"
#include "gl/offscreen_context.h"

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
  std::int64_t segmentFrames = kSegmentFrames;
  bool resume = false;                                 ///< what is there and is the same is not made again
  bool keepWork = false;                               ///< leaves the segments when all is done
  std::optional<Shard> shard = {};                     ///< only its segments, and no film of them
  std::optional<std::filesystem::path> manifest = {};  ///< of a film or a sequence
  std::optional<std::filesystem::path> trace = {};     ///< TraceFile of it
  std::optional<JobFile> job = {};                     ///< jobFileOf() this, of a film and a sequence
  bool digestsPixels = false;  ///< of a still: whether the worker reports the pixelDigest()
  double worker_bytes = 0;     ///< that a worker is estimated to take (memory.h), for messages

  /// Returns the segments that this render makes: all, or its shard's.
  std::vector<FrameRange> segments() const {
    return segmentsOf(shard.value_or(Shard()), segmentsOf(frames, segmentFrames));
  }
};

}  // namespace poinsot::app
