// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/units.h"

namespace poinsot::request {

/// Preferred unit of each dimension. Quantities of other dimensions keep their units.
using UnitChoice = std::map<scene::Dimension, std::string>;

/// A scene key and its value as TOML.
struct DefaultKey {
  std::string path, value;
};

/// Defaults of a user: how values are displayed and how a new scene begins. Defaults never change what a scene
/// means, which is the same everywhere.
struct UserDefaults {
  UnitChoice units;
  std::vector<DefaultKey> keys;
};

/// Returns $XDG_CONFIG_HOME/poinsot/defaults.toml, else ~/.config/poinsot/defaults.toml; empty if the environment
/// names neither folder.
std::filesystem::path userDefaultsFile();

/// Reads a defaults file. Its table [units] maps a dimension ("angular_velocity") to a unit; [scene] holds keys
/// with their values. A missing file counts as an empty one.
/// @throws scene::SceneErrors with all problems and their places; core::Error(kIo) if the file cannot be read.
UserDefaults defaultsOf(const std::filesystem::path& file);

/// Returns the name of a dimension in [units], such as "angular_velocity".
std::string dimensionWord(scene::Dimension dimension);

}  // namespace poinsot::request
