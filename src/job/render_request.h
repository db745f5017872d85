// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "gl/offscreen_context.h"
#include "job/job_record.h"
#include "request/frame_plan.h"
#include "request/output_target.h"
#include "request/picture_options.h"
#include "request/requested_scene.h"

namespace poinsot::job {

/// Choices of a caller besides the scene, the target and the frames.
struct RenderChoices {
  std::optional<double> time_s = {};  ///< of a still: film time in place of the frame's own
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = false;  ///< always, where it is a shard: the machines of a cluster differ
  request::PictureOptions form = {};
  std::int64_t segmentFrames = request::kSegmentFrames;
  bool resume = false;                                 ///< what is there and is the same is not made again
  bool keepWork = false;                               ///< leaves the segments when all is done
  std::optional<request::Shard> shard = {};            ///< only its segments, and no film of them
  std::optional<std::filesystem::path> manifest = {};  ///< of a film or a sequence
  std::optional<std::filesystem::path> trace = {};     ///< TraceFile of it
  bool digestsPixels = false;  ///< of a still: whether the worker reports the pixelDigest()
};

/// One render, ready to run: the same value from the options to the worker, which inherits it as a fork.
struct RenderRequest : RenderChoices {
  request::RequestedScene scene = {};
  request::OutputTarget target = {};
  request::FrameRange frames = {};
  int workers = 1;                       ///< most processes
  double worker_bytes = 0;               ///< that a worker is estimated to take
  std::optional<JobRecord> record = {};  ///< of what is made in segments: a film, a sequence, a shard

  /// Returns the segments that this render makes: all, or its shard's.
  std::vector<request::FrameRange> segments() const {
    return request::segmentsOf(shard.value_or(request::Shard()), request::segmentsOf(frames, segmentFrames));
  }
};

/// The only way to make one. `workers` is left to the caller, who knows the machine.
/// @throws core::Error(kPhysics) as describe::pictureWords().
RenderRequest renderRequest(request::RequestedScene scene, const request::OutputTarget& target,
                            const request::FrameRange& frames, const RenderChoices& choices = {});

/// @throws core::Error(kLimit) if a worker would take more memory than the scene's allowance has.
void expectWithinMemory(const RenderRequest& request);

/// Values that all workers of a render inherit.
struct WorkerTask {
  const RenderRequest& render;
  std::filesystem::path workFolder;  ///< takes the segments of a film
  int rasterThreads = 0;             ///< llvmpipe's; 0 rasterises in the worker itself

  /// Whether segments that are there are taken.
  bool resumes() const { return render.resume || render.shard; }
};

}  // namespace poinsot::job
