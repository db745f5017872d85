// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "preview/film_errand.h"
#include "preview/watched_scene.h"
#include "request/user_files.h"

/// JSON responses to the preview page.
namespace poinsot::preview {

/// Returns the version number and error of the newest files. For the last scene without errors, also returns its
/// film, size, timeline, physics and the quantities that can be plotted.
/// @param units  units for the physics
std::string sceneJson(const SceneVersion& version, const request::UnitChoice& units);

/// Returns the values of quantities over the film, with their times: at most 1000 samples of each quantity.
/// @param names  names of the quantities, as in a scene
/// @throws core::Error(kUsage) for an unknown name; core::Error(kPhysics)
std::string seriesJson(const scene::Scene& scene, const std::vector<std::string>& names);

std::string filmJson(const FilmState& state);

}  // namespace poinsot::preview
