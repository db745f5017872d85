// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

namespace poinsot::core {

/// Method of resolving a path. kByTheKernel uses openat2 (Linux 5.6 or later), or kFolderByFolder if that call
/// fails because of an old kernel or a sandbox. Both methods give the same result.
enum class Following { kByTheKernel, kFolderByFolder };

/// Opens the regular file `relative`, in or below `folder`, for reading. Follows no symbolic links, even if
/// another process replaces a folder with a link meanwhile. Checks the kind of file before opening it, because
/// opening a pipe or device may have effects.
/// @param folder  root, or the current folder if empty; links on the path of this folder are followed
/// @returns an empty handle, with errno set, on failure: ELOOP for a symbolic link, EXDEV for a path that leads
/// out of the folder, EISDIR for a folder, EINVAL for a pipe or device
FileHandle openBeneath(const std::filesystem::path& folder, const std::filesystem::path& relative,
                       Following following = Following::kByTheKernel);

}  // namespace poinsot::core
