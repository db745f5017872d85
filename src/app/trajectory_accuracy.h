// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/trajectory_times.h"
#include "scene/scene.h"

namespace poinsot::app {

/// A sentence, where the farthest of these motion times is so far that the attitude is not exact to rounding; else
/// empty.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::app
