// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/scene_frames.h"
#include "app/worker.h"
#include "app/worker_protocol.h"

namespace poinsot::app {

/// Sinks for the job's kind of target: a segment of film in the work folder, or pictures and figures under their
/// final names. All four must outlive the sinks, which enter their time into `steps`.
SinkMaker sinkMaker(const WorkerJob& job, const scene::Scene& scene, SceneFrames& frames, core::StepLedger& steps);

}  // namespace poinsot::app
