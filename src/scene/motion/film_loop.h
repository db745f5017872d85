// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Changes a scene so that its film repeats without a jump. Changes the start of the motion by as little as
/// possible, so that the attitude returns after about the length of the film: a free motion at the same |L|, the
/// steady precession of a heavy top at the same lean. Rounds the duration to a whole number of frames, and adjusts
/// the speed to fit. Records the changes in Time::loop. Source: physics/closed_motion.h, physics/heavy_top.h.
/// @throws core::Error(kScene) for other driven motion, a film that ends at another pace than
/// it begins, a thrown body that moves through a view, speed 0, or a film that
/// would be too long; core::Error(kPhysics) on the separatrix.
void closeLoop(Scene& scene, const Limits& limits = {});

}  // namespace poinsot::scene
