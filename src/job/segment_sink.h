// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "job/render_request.h"
#include "job/scene_frames.h"
#include "job/worker.h"

namespace poinsot::job {

/// Returns the temporary paths of the files of a still (figure::figureFiles()) in the work folder. A worker writes
/// these files, and the render later renames them together.
std::vector<std::filesystem::path> stagedFiles(const std::filesystem::path& workFolder,
                                               const request::OutputTarget& target);

/// Returns a function that creates the sink of a segment. Film segments and stills are written to the work folder,
/// frames of a sequence to their final names. All arguments must outlive the sinks. The sinks add their time to
/// `steps`.
SinkMaker sinkMaker(const WorkerTask& task, SceneFrames& frames, core::StepLedger& steps);

}  // namespace poinsot::job
