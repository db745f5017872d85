// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "preview/film_errand.h"
#include "preview/watched_scene.h"
#include "request/user_files.h"

/// What the page is told.
namespace poinsot::preview {

/// Number, mistake; of the last scene without one its film, its size, the physics and the quantities to plot.
/// @param units  that the physics is told in.
std::string sceneJson(const SceneVersion& version, const request::UnitChoice& units);

/// Quantities of the motion over the film, by their names in a scene: times and values, at most a thousand of
/// each.
/// @throws core::Error(kUsage) of a name that is none, kPhysics
std::string seriesJson(const scene::Scene& scene, const std::vector<std::string>& names);

std::string filmJson(const FilmState& state);

}  // namespace poinsot::preview
