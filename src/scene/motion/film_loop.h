// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Makes the film of a scene repeat without a jump: moves the start of the motion that it shows as little as can
/// be, at the same |L|, to one after which the attitude comes back in about the film's length; makes the film as
/// many whole frames long as that takes at the scene's speed; and changes the speed by the rest. Fills
/// Time::loop with what was changed. Source: physics/closed_motion.h.
/// @throws core::Error(kScene) for driven motion and for a film that would be too long, kPhysics on the
/// separatrix.
void closeLoop(Scene& scene, const Limits& limits = {});

}  // namespace poinsot::scene
