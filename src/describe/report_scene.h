// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "scene/scene.h"

namespace poinsot::describe {

/// What one would work out by hand about a scene: every number from the physics layer.
/// @throws core::Error(kPhysics) for a motion that has no solution.
Report sceneReport(const scene::Scene& scene);

}  // namespace poinsot::describe
