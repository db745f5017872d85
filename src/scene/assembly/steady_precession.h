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

}  // namespace poinsot::scene
