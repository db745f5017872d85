// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/assembly/parts.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Returns why the scene's motion has no steady precession; empty if it has one.
/// @pre its start is known
std::string withoutPrecession(const Scene& scene, const std::optional<Rest>& rest);

/// Returns why the scene's motion has no axes i, j, k with i in the plane of L and k; empty if it has them.
/// @pre its start is known
std::string withoutTriad(const Scene& scene, const std::optional<Rest>& rest);

/// Returns why omega draws no cones in the body and in space; empty if it draws them.
/// @pre its start is known
std::string withoutCones(const Scene& scene, const std::optional<Rest>& rest);

}  // namespace poinsot::scene
