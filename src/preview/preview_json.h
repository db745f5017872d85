// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "preview/film_errand.h"
#include "preview/watched_scene.h"
#include "request/user_files.h"

/// JSON answers to the page of the preview.
namespace poinsot::preview {

/// Returns the number and the error of a version, and of the last scene without errors its film, size, physics and
/// quantities to plot.
/// @param units  units of the physics
std::string sceneJson(const SceneVersion& version, const request::UnitChoice& units);

/// Returns quantities of the motion over the film: at most 1000 samples of each, with their times.
/// @param names  names of the quantities, as in a scene
/// @throws core::Error(kUsage) for an unknown name; core::Error(kPhysics)
std::string seriesJson(const scene::Scene& scene, const std::vector<std::string>& names);

std::string filmJson(const FilmState& state);

}  // namespace poinsot::preview
