// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "physics/driven_motion.h"
#include "physics/motion.h"
#include "scene/event_kinds.h"
#include "scene/motion/film_clock.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Instant at which something happens in a scene.
struct SceneEvent {
  int kind = 0;                  ///< index into eventKinds()
  double t_s = 0;                ///< motion time
  std::optional<FilmSpan> film;  ///< film times; nullopt if the film does not show the event
};

/// Returns the events of a scene in a span of motion time, in the order from its first end to its second end.
/// @param motion  makeMotion() of the scene, which covers the span
/// @param clock  clock of the scene's film
/// @throws core::Error(kLimit) as physics::motionEvents()
std::vector<SceneEvent> sceneEvents(const Scene& scene, const physics::Motion& motion, const FilmClock& clock,
                                    const physics::TimeSpan& span);

}  // namespace poinsot::scene
