// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "job/job_record.h"
#include "job/statistics.h"
#include "output/file_kind.h"

namespace poinsot::job {

/// Manifests of this program.
output::FileKind manifestKind();

/// Returns all that is known of a finished film or sequence, as JSON for people and programs: what it was made
/// from and with what, the digest of each frame, the SHA-256 of each file, and what it cost. Call before its work
/// folder is gone.
/// @param film  where the content of a film is, which may have no name yet
/// @throws core::Error(kIo).
std::string manifestText(const std::filesystem::path& workFolder, const JobRecord& job,
                         const request::OutputTarget& target, const std::filesystem::path& film,
                         const RenderSummary& summary);

}  // namespace poinsot::job
