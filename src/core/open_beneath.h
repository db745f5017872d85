// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/file_handle.h"

/// Opening files that somebody else names, and nothing outside a folder.
namespace poinsot::core {

/// How a path is followed. The kernel's own way (openat2, since Linux 5.6) knows nothing of what a sandbox or an
/// old kernel forbids; then folder by folder does the same.
enum class Following { kByTheKernel, kFolderByFolder };

/// A regular file at `relative`, in `folder` or below it, for reading. No symbolic link is followed, also none
/// that takes a folder's place while the file is opened; what is no regular file is looked at but never opened, so
/// that a pipe's writer and a device notice nothing. Empty where there is none such, and errno says why: ELOOP for
/// a symbolic link, EXDEV for a path that leads out, EISDIR, EINVAL for what is neither a file nor a folder.
/// @param folder  empty: the current one; links on the way to it are followed, as it is named by the user
FileHandle openBeneath(const std::filesystem::path& folder, const std::filesystem::path& relative,
                       Following following = Following::kByTheKernel);

}  // namespace poinsot::core
