// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "app/job_file.h"
#include "app/render_summary.h"

namespace poinsot::app {

/// All that is known of a finished film or sequence, as JSON for people and programs: what it was made from and
/// with what, the digest of each frame, the SHA-256 of each file, and what it cost. Call before its work folder is
/// gone.
/// @throws core::Error(kIo).
void writeManifest(const std::filesystem::path& file, const std::filesystem::path& workFolder, const JobFile& job,
                   const OutputTarget& target, const RenderSummary& summary);

}  // namespace poinsot::app
