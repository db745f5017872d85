// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/units.h"

namespace poinsot::request {

/// Units in which values are displayed, by dimension. Values of other dimensions have their usual units.
using UnitChoice = std::map<scene::Dimension, std::string>;

/// Key of a scene, and its value as TOML.
struct DefaultKey {
  std::string path, value;
};

/// Defaults of a user: units in which values are displayed, and keys of new scenes. They never change an old
/// scene.
struct UserDefaults {
  UnitChoice units;
  std::vector<DefaultKey> keys;
};

/// Returns $XDG_CONFIG_HOME/poinsot/defaults.toml or, without this variable, ~/.config/poinsot/defaults.toml.
/// Empty if the environment names neither folder.
std::filesystem::path userDefaultsFile();

/// Reads a file with defaults. The table [units] sets units by dimension, such as "angular_velocity". The table
/// [scene] contains keys of a scene. A missing file counts as an empty file.
/// @throws scene::SceneErrors with all problems and their positions; core::Error(kIo) if the file cannot be read.
UserDefaults defaultsOf(const std::filesystem::path& file);

/// Returns the name of a dimension in the table [units], such as "angular_velocity".
std::string dimensionWord(scene::Dimension dimension);

}  // namespace poinsot::request
