// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/document.h"
#include "scene/limits.h"
#include "scene/units.h"

namespace poinsot::request {

/// Where a user keeps a file of that name: $XDG_CONFIG_HOME/poinsot/NAME, else ~/.config/poinsot/NAME; empty where
/// the environment names neither folder.
std::filesystem::path userFile(std::string_view name);

/// Takes what a user's file says, an entry after the other; what is wrong goes to the problems. A file that is not
/// there says nothing.
/// @throws scene::SceneErrors with all problems and where; core::Error(kIo) if it cannot be read.
void readUserFile(const std::filesystem::path& file,
                  const std::function<void(const scene::Entry&, scene::Problems&)>& take);

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

/// userFile() of the name defaults.toml.
std::filesystem::path userDefaultsFile();

/// Of a file with the tables [units], a unit by the name of a dimension ("angular_velocity"), and [scene], keys
/// with their values. A file that is not there says nothing.
/// @throws scene::SceneErrors with all that is wrong in it and where; core::Error(kIo) if it cannot be read.
UserDefaults defaultsOf(const std::filesystem::path& file);

/// "angular_velocity".
std::string dimensionWord(scene::Dimension dimension);

/// Where a user keeps limits of his own: userFile() of the name limits.toml.
std::filesystem::path userLimitsFile();

/// The usual limits with those of a file above them: keys are names of limits, values whole numbers or sizes as
/// text. A file that is not there changes nothing.
/// @throws scene::SceneErrors with all that is wrong in it and where; core::Error(kIo) if it cannot be read.
scene::Limits limitsOf(const std::filesystem::path& file);

}  // namespace poinsot::request
