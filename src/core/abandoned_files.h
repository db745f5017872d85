// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// Returns the hidden name of a temporary file in `folder`: .NAME.PID-ATTEMPT.SPACE.tmp. NAME is the target's file
/// name, PID the process that writes the file, and SPACE the PID namespace (processSpace()).
std::filesystem::path temporaryName(const std::filesystem::path& folder, const std::filesystem::path& target,
                                    int attempt);

/// Removes the temporary files in `folder` whose processes have ended. Only the first call for a folder has an
/// effect. Files from other machines or containers stay.
void removeAbandonedFilesOnce(const std::filesystem::path& folder) noexcept;

}  // namespace poinsot::core
