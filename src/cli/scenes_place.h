// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::cli {

/// Where scenes are looked for without being told: the folder POINSOT_SCENES (the launcher names that of its
/// checkout), the one that was installed with the program, or scenes/ here.
std::string scenesPlace();

/// The scenes (NAME.toml) in a folder, sorted; at least one.
/// @throws core::Error(kIo) if it cannot be read; core::Error(kUsage) if none is there.
std::vector<std::filesystem::path> scenesIn(const std::filesystem::path& folder);

}  // namespace poinsot::cli
