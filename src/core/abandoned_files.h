// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// Returns the hidden name of a temporary file in `folder`: .NAME.PID-ATTEMPT.SPACE.tmp. NAME is the target's file
/// name, PID is the process that writes the file, and SPACE identifies the PID namespace (processSpace()).
std::filesystem::path temporaryName(const std::filesystem::path& folder, const std::filesystem::path& target,
                                    int attempt);

/// Removes temporary files in `folder` that were left behind by processes which have ended. Keeps files from other
/// machines and containers. Only the first call for a folder has an effect.
void removeAbandonedFilesOnce(const std::filesystem::path& folder) noexcept;

}  // namespace poinsot::core
