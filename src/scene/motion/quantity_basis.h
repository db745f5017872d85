// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "physics/motion.h"
#include "scene/scene.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {

/// Returns the basis for the quantities of a scene. Plots, read-outs and trajectories share it, so that they agree
/// about the axis k.
/// @param motion  motion of the scene, or the motion that its film shows
/// @throws core::Error(kLimit) if the motion does not cover time.start of the scene
QuantityBasis quantityBasis(const Scene& scene, const physics::Motion& motion);

/// Returns what a scene lacks for a quantity, such as "exists only for a thrown body; give [motion.flight]". Empty
/// if it lacks nothing.
std::string lackFor(const StateQuantity& quantity, const Scene& scene);

}  // namespace poinsot::scene
