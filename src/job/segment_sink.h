// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "job/render_request.h"
#include "job/scene_frames.h"
#include "job/worker.h"

namespace poinsot::job {

/// Where a still's worker leaves the files that figure::figureFiles() names, for the render to give them their
/// names together.
std::vector<std::filesystem::path> stagedFiles(const std::filesystem::path& workFolder,
                                               const request::OutputTarget& target);

/// Sinks for the render's kind of target: a segment of film or a still in the work folder, or frames of a sequence
/// under their final names. All three must outlive the sinks, which enter their time into `steps`.
SinkMaker sinkMaker(const WorkerTask& task, SceneFrames& frames, core::StepLedger& steps);

}  // namespace poinsot::job
