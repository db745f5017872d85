// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::core {

/// A temporary folder, and the lock that says that a process still has it.
struct ClaimedFolder {
  std::filesystem::path path;  ///< empty if none could be made
  FileHandle claim;            ///< empty where the file system cannot lock: nobody takes it for abandoned
};

/// Makes a folder poinsot-?????? in `place`, marked as this process's until the claim is closed here and in every
/// fork, or they end. Until it is marked it is named .poinsot-??????. Returns no path, and errno, if it cannot.
ClaimedFolder makeClaimedFolder(const std::filesystem::path& place);

/// Removes a folder of this process's, under the name .poinsot-??????, so that a kill at any moment leaves
/// a folder that removeAbandonedFolders() recognises.
void removeClaimedFolder(const std::filesystem::path& folder);

/// Removes the folders named poinsot-?????? or .poinsot-?????? in `place` whose processes ended without removing
/// them (SIGKILL).
///
/// A process that lives holds a lock, which the kernel releases when it ends; process numbers mean nothing where
/// containers share /tmp. A folder is removed only if it is no link, belongs to this user and to no other (0700),
/// and was claimed under the running kernel, because locks may not reach another machine, or is empty and has the
/// hidden name. If anything goes wrong, it is left to the next start.
void removeAbandonedFolders(const std::filesystem::path& place) noexcept;

}  // namespace poinsot::core
