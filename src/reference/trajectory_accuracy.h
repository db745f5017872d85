// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reference/trajectory_times.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// A sentence if the attitude at the farthest of these motion times is uncertain by more than 0.02 rad: the body
/// has turned too far for a double's phase, or the run amplifies the rounding of its input, most of all close to
/// the separatrix. Empty otherwise, and for driven motion.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::reference
