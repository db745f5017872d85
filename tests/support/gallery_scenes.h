// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_file.h"

/// Scenes of the gallery: every NAME.toml in scenes/, as `poinsot gallery` finds them.
namespace poinsot {

inline std::filesystem::path galleryFolder() { return std::filesystem::path(POINSOT_SOURCE_DIR) / "scenes"; }

inline scene::Scene galleryScene(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return scene::loadScene(galleryFolder() / (name + ".toml"), overrides);
}

inline std::vector<std::string> galleryNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(galleryFolder()))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

}  // namespace poinsot
