// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::cli {

/// Returns the default folder of scenes: POINSOT_SCENES (which the launcher sets to the scenes of its checkout),
/// else the folder that was installed with the program, else scenes/ in the current folder.
std::string scenesPlace();

/// Returns the scenes (NAME.toml) in a folder, sorted; at least one.
/// @throws core::Error(kIo) if the folder cannot be read; core::Error(kUsage) if it has no scene
std::vector<std::filesystem::path> scenesIn(const std::filesystem::path& folder);

}  // namespace poinsot::cli
