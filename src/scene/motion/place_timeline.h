// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace poinsot::scene {

/// Mistake in the moment of a timeline entry.
struct MomentProblem {
  std::size_t place = 0;  ///< index of the entry in the scene file
  std::string message;
};

/// Computes the film time at which each entry of the timeline begins, sorts the entries by it, and makes the
/// captions. An event or a motion time is looked up at the speed that the earlier entries give. At a standstill,
/// and at a speed of both signs, the first film time with the motion time counts.
/// @return mistakes; their entries are removed
/// @pre body, motion and time of the scene are set, if an entry names an event or a motion time
std::vector<MomentProblem> placeTimeline(Scene& scene);

}  // namespace poinsot::scene
