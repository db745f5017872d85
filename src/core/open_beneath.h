// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::core {

/// Method of resolving a path. kByTheKernel uses openat2 (Linux 5.6 or later). If an old kernel or a sandbox
/// forbids that call, it falls back to kFolderByFolder, which has the same result.
enum class Following { kByTheKernel, kFolderByFolder };

/// Opens the regular file `relative`, in or below `folder`, for reading. Follows no symbolic link, not even one
/// that replaces a folder meanwhile. Checks the kind of file before opening it, so that pipes and devices notice
/// nothing.
/// @param folder  the current folder if empty; links on the way to it are followed, because the user names it
/// @returns an empty handle, with errno set, on failure: ELOOP for a symbolic link, EXDEV for a path that leads
/// out of the folder, EISDIR for a folder, EINVAL for a pipe or device
FileHandle openBeneath(const std::filesystem::path& folder, const std::filesystem::path& relative,
                       Following following = Following::kByTheKernel);

}  // namespace poinsot::core
