// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::cli {

/// Returns the default folder of scenes. This is POINSOT_SCENES if set, else the folder installed with the
/// program, else scenes/ in the current folder. The launcher sets POINSOT_SCENES to the scenes of its checkout.
std::string scenesPlace();

/// Returns the scenes (NAME.toml) in a folder, sorted by name. Never returns an empty list.
/// @throws core::Error(kIo) if the folder cannot be read; core::Error(kUsage) if it has no scene
std::vector<std::filesystem::path> scenesIn(const std::filesystem::path& folder);

}  // namespace poinsot::cli
