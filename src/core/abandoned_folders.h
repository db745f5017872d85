// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::core {

/// Temporary folder, and the lock which shows that a running process uses the folder.
struct ClaimedFolder {
  std::filesystem::path path;
  FileHandle claim;  ///< the lock; empty if the file system cannot lock, and nobody then removes the folder
};

/// Creates and locks a folder poinsot-?????? in `place`. The folder is named .poinsot-?????? until it is locked.
/// The lock lasts until this process and all its forks have closed the claim or ended.
/// @returns an empty path, with errno set, if the folder cannot be created
ClaimedFolder makeClaimedFolder(const std::filesystem::path& place);

/// Renames a folder of this process to .poinsot-?????? and removes it. If the process is killed in between, a
/// later removeAbandonedFolders() removes the rest.
void removeClaimedFolder(const std::filesystem::path& folder);

/// Removes folders named poinsot-?????? or .poinsot-?????? in `place` that a killed process left behind (SIGKILL).
///
/// A running process holds a lock on its folder, and the kernel releases the lock when the process ends. PIDs
/// would not work, because containers may share /tmp. A folder is removed only if it is a real folder with mode
/// 0700 that belongs to this user. Its claim must name the running kernel, because locks may not reach another
/// machine. A folder .poinsot-?????? without a claim is removed if it is empty. After an error, the folder is left
/// to the next start.
void removeAbandonedFolders(const std::filesystem::path& place) noexcept;

}  // namespace poinsot::core
