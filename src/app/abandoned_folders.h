// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::app {

/// Marks a temporary folder as this process's, until the result is closed here and in every fork, or they end.
/// Returns none where the file system cannot lock; nobody takes such a folder for abandoned.
core::FileHandle claimFolder(const std::filesystem::path& folder);

/// Removes a folder of this process's. The mark goes last, so that a kill on the way leaves it to be removed.
void removeClaimedFolder(const std::filesystem::path& folder);

/// Removes the claimed folders named poinsot-?????? in `place` whose processes ended without removing them
/// (SIGKILL).
///
/// A process that lives holds a lock, which the kernel releases when it ends; process numbers mean nothing where
/// containers share /tmp. A folder is removed only if it is no link, belongs to this user and to no other (0700),
/// is claimed, and was claimed under the running kernel, because locks may not reach another machine. If anything
/// goes wrong, it is left to the next start.
void removeAbandonedFolders(const std::filesystem::path& place) noexcept;

}  // namespace poinsot::app
