// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// Returns the hidden name, in `folder`, of a file that is not complete: .NAME.PID-ATTEMPT.SPACE.tmp. The process
/// that has the number PID is writing it; SPACE says among which processes the number counts.
std::filesystem::path temporaryName(const std::filesystem::path& folder, const std::filesystem::path& target,
                                    int attempt);

/// Removes the files of a folder that have such names and whose processes have ended, the first time that this
/// process asks. Another machine or container has another SPACE, so its files stay.
void removeAbandonedFilesOnce(const std::filesystem::path& folder) noexcept;

}  // namespace poinsot::core
