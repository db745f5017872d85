// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "job/render_request.h"
#include "job/scene_frames.h"
#include "job/worker.h"

namespace poinsot::job {

/// Returns the paths in the work folder where a still's worker writes the files of figure::figureFiles(). The
/// render then gives all of them their final names together.
std::vector<std::filesystem::path> stagedFiles(const std::filesystem::path& workFolder,
                                               const request::OutputTarget& target);

/// Returns the maker of sinks for a render. Film segments and stills go to the work folder, frames of a sequence
/// to their final names. All three arguments must outlive the sinks, which enter their time into `steps`.
SinkMaker sinkMaker(const WorkerTask& task, SceneFrames& frames, core::StepLedger& steps);

}  // namespace poinsot::job
