// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::core {

/// Temporary folder, with the lock that marks it as in use by a running process.
struct ClaimedFolder {
  std::filesystem::path path;
  FileHandle claim;  ///< empty if the file system cannot lock; the folder then never counts as abandoned
};

/// Makes and locks a folder poinsot-?????? in `place`. The lock lasts until the claim is closed in this process
/// and all its forks, or they end. The folder is named .poinsot-?????? until it is locked.
/// @returns an empty path, with errno set, if the folder cannot be made
ClaimedFolder makeClaimedFolder(const std::filesystem::path& place);

/// Renames a folder of this process to .poinsot-?????? and removes it. If the process is killed meanwhile,
/// removeAbandonedFolders() recognises what is left.
void removeClaimedFolder(const std::filesystem::path& folder);

/// Removes folders named poinsot-?????? or .poinsot-?????? in `place` whose processes ended without removing them
/// (SIGKILL).
///
/// A running process holds a lock, which the kernel releases when the process ends. PIDs do not serve, because
/// containers may share /tmp. A folder is removed only if it is not a link, has mode 0700 and belongs to this
/// user. It must also have been claimed under the running kernel, because locks may not reach another machine, or
/// be empty and named .poinsot-??????. After an error the folder is left to the next start.
void removeAbandonedFolders(const std::filesystem::path& place) noexcept;

}  // namespace poinsot::core
