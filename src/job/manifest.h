// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "job/job_record.h"
#include "job/statistics.h"
#include "output/file_kind.h"

namespace poinsot::job {

output::FileKind manifestKind();

/// Returns the manifest of a finished film or sequence as JSON. The manifest lists inputs and settings, the digest
/// of each frame, the SHA-256 of each file, and the time and memory used. Call this function before the work
/// folder is removed.
/// @param film  file with the content of the film, possibly under a temporary name
/// @throws core::Error(kIo).
std::string manifestText(const std::filesystem::path& workFolder, const JobRecord& job,
                         const request::OutputTarget& target, const std::filesystem::path& film,
                         const RenderSummary& summary);

}  // namespace poinsot::job
