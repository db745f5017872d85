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

/// File sizes from `least` to `most`.
struct SizeRange_bytes {
  std::int64_t least = 0, most = 0;

  bool contains(std::int64_t size) const { return least <= size && size <= most; }
};

/// Options of a render. Scene, target and frames are in RenderRequest.
struct RenderChoices {
  std::optional<double> time_s =
      {};  ///< stills only: film time to draw; it replaces the time that follows from the frame number
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = false;  ///< always true for a shard, because the machines of a cluster differ
  request::PictureOptions form = {};
  std::int64_t segmentFrames = request::kSegmentFrames;
  bool resume = false;  ///< reuses matching segments of an earlier render
  bool keepWork = false;
  std::optional<request::Shard> shard = {};            ///< renders this shard's segments, without joining
  std::optional<std::filesystem::path> manifest = {};  ///< films and sequences only
  std::optional<std::filesystem::path> trace = {};
  /// films only: writes no files unless the film's size is in this range, and leaves no segments to resume
  std::optional<SizeRange_bytes> accepted = {};
  bool digestsPixels = false;  ///< stills only: the worker reports the pixelDigest()
};

/// Complete description of one render. Workers inherit a copy by fork().
struct RenderRequest : RenderChoices {
  request::RequestedScene scene = {};
  request::OutputTarget target = {};
  request::FrameRange frames = {};
  int workers = 1;                       ///< maximum number of worker processes
  double worker_bytes = 0;               ///< estimated memory of one worker
  std::optional<JobRecord> record = {};  ///< set for films, sequences and shards, which are made in segments

  /// Returns all segments, or the segments of the shard if there is one.
  std::vector<request::FrameRange> segments() const {
    return request::segmentsOf(shard.value_or(request::Shard()), request::segmentsOf(frames, segmentFrames));
  }
};

/// Returns a request with its memory estimate and its job record. Do not fill in a RenderRequest by hand. The
/// caller sets `workers`, which depends on the machine.
/// @throws core::Error(kPhysics) like describe::pictureWords().
RenderRequest renderRequest(request::RequestedScene scene, const request::OutputTarget& target,
                            const request::FrameRange& frames, const RenderChoices& choices = {});

/// @throws core::Error(kLimit) if a worker would need more memory than the scene's limits allow.
void expectWithinMemory(const RenderRequest& request);

/// Values that all workers of a render inherit from the main process.
struct WorkerTask {
  const RenderRequest& render;
  std::filesystem::path workFolder;
  int rasterThreads = 0;  ///< extra threads of llvmpipe; 0 draws on the worker's own thread

  bool resumes() const { return render.resume || render.shard; }
};

}  // namespace poinsot::job
