// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace poinsot::core {

/// Returns the regular files of a folder, sorted by name. A folder that does not exist has none.
/// @param links  returns the symbolic links of the folder instead
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, bool links = false);

/// Checks that no folder between `folder` and `file`, which is named below it, is a link: a file written or read
/// through one would lie elsewhere. `folder` itself may be a link.
/// @throws core::Error(kIo)
void expectNoLinkAbove(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace poinsot::core
