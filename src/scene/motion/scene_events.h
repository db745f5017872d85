// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "physics/driven_motion.h"
#include "physics/motion.h"
#include "scene/motion/film_clock.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Kind of an event of a scene: the kinds of physics::MotionEventKind, and the highest point of a flight.
struct EventKind {
  std::string_view word;     ///< word in files, such as "flip"
  std::string_view plural;   ///< name in a table, such as "flips"
  std::string_view meaning;  ///< condition of the event, such as "omega_mid changes sign"
};

/// Returns all kinds, in the order of the reference. Events store indices into this list.
std::span<const EventKind> eventKinds();

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
