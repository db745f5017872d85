// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace poinsot::core {

/// Returns the regular files of a folder, sorted by name. Returns nothing if the folder does not exist.
/// @param links  if true, returns the symbolic links of the folder instead
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, bool links = false);

/// Checks that none of the folders between `folder` and `file` is a symbolic link, because a link may lead out of
/// `folder`. `folder` itself may be a link.
/// @param file  a path below `folder`
/// @throws core::Error(kIo) if there is such a link
void expectNoLinkAbove(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace poinsot::core
