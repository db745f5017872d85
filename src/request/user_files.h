// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/units.h"

namespace poinsot::request {

/// The unit that somebody wants quantities of a dimension in; none: as they are.
using UnitChoice = std::map<scene::Dimension, std::string>;

/// A key of a scene and its value, as TOML.
struct DefaultKey {
  std::string path, value;
};

/// What a user always wants. It decides how things are told and what a new scene begins with, never what a scene
/// means: that is the same everywhere.
struct UserDefaults {
  UnitChoice units;
  std::vector<DefaultKey> keys;  ///< in the order of the file
};

/// Where a user keeps them: $XDG_CONFIG_HOME/poinsot/defaults.toml, else ~/.config/poinsot/defaults.toml; empty
/// where the environment names neither folder.
std::filesystem::path userDefaultsFile();

/// Of a file with the tables [units], a unit by the name of a dimension ("angular_velocity"), and [scene], keys
/// with their values. A file that is not there says nothing.
/// @throws scene::SceneErrors with all that is wrong in it and where; core::Error(kIo) if it cannot be read.
UserDefaults defaultsOf(const std::filesystem::path& file);

/// "angular_velocity".
std::string dimensionWord(scene::Dimension dimension);

}  // namespace poinsot::request
