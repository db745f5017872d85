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
/// A lock tells, which the kernel releases; process numbers mean nothing where containers share /tmp. So that no
/// living folder is ever taken for an abandoned one, a folder stays unless all of this holds: it is no link, this
/// user's and only this user's (0700), claimed, and claimed under the running kernel, as locks may not reach
/// another machine. Whatever goes wrong leaves it to the next start.
void removeAbandonedFolders(const std::filesystem::path& place) noexcept;

}  // namespace poinsot::app
