// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace poinsot::core {

/// Returns the regular files of a folder, sorted by name; none if the folder does not exist.
/// @param links  if true, returns the symbolic links of the folder instead
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, bool links = false);

/// Checks that no folder between `folder` and `file`, a path below it, is a symbolic link, through which the file
/// would lie elsewhere. `folder` itself may be a link.
/// @throws core::Error(kIo) if there is such a link
void expectNoLinkAbove(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace poinsot::core
