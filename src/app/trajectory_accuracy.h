// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/trajectory_times.h"
#include "scene/scene.h"

namespace poinsot::app {

/// A sentence where the attitude at the farthest of these motion times is not known to a hundredth of a radian:
/// the body has turned too far for a double's phase, or passes its middle axis so closely (near the separatrix)
/// that the last digit of the input decides where it is. Empty otherwise, and for driven motion.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::app
