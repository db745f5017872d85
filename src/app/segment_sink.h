// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/scene_frames.h"
#include "app/worker.h"
#include "app/worker_protocol.h"

namespace poinsot::app {

/// CPU seconds spent after a frame was made.
struct EncodingTimes {
  double convert_s = 0;  ///< RGB to the encoder's pixels
  double encode_s = 0;   ///< the encoder, or PNG compression, a figure's vectors; writing included
};

/// Sinks for the job's kind of target: a segment of film in the work folder, or pictures and figures under their
/// final names. All four must outlive the sinks; `times` grows by what they spend.
SinkMaker sinkMaker(const WorkerJob& job, const scene::Scene& scene, SceneFrames& frames, EncodingTimes& times);

}  // namespace poinsot::app
