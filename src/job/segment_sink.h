// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "job/scene_frames.h"
#include "job/worker.h"
#include "job/worker_protocol.h"

namespace poinsot::job {

/// Where a still's worker leaves the files that output::figureFiles() names, for the render to give them their
/// names together.
std::vector<std::filesystem::path> stagedFiles(const std::filesystem::path& workFolder,
                                               const request::OutputTarget& target);

/// Sinks for the job's kind of target: a segment of film or a still in the work folder, or frames of a sequence
/// under their final names. All four must outlive the sinks, which enter their time into `steps`.
SinkMaker sinkMaker(const WorkerJob& job, const scene::Scene& scene, SceneFrames& frames, core::StepLedger& steps);

}  // namespace poinsot::job
