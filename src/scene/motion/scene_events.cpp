// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/scene_events.h"

#include <algorithm>

#include "physics/motion_events.h"

namespace poinsot::scene {
namespace {

bool within(double t_s, const physics::TimeSpan& span) {
  return std::min(span.from_s, span.to_s) <= t_s && t_s <= std::max(span.from_s, span.to_s);
}

}  // namespace

std::vector<SceneEvent> sceneEvents(const Scene& scene, const physics::Motion& motion, const FilmClock& clock,
                                    const physics::TimeSpan& span) {
  std::vector<SceneEvent> events;
  for (const physics::MotionEvent& event : physics::motionEvents(motion, scene.motion.forcing, span))
    events.push_back({static_cast<int>(event.kind), event.t_s, {}});
  if (scene.motion.flight && !scene.motion.flight->gravity_W.isZero(0)) {
    const double top_s = scene.motion.flight->top().t_s;
    if (within(top_s, span)) events.push_back({kHighestPoint, top_s, {}});
    if (top_s > 0 && within(2 * top_s, span)) events.push_back({kCatch, 2 * top_s, {}});
  }
  const bool backwards = span.to_s < span.from_s;
  std::ranges::stable_sort(
      events, [&](const SceneEvent& a, const SceneEvent& b) { return backwards ? a.t_s > b.t_s : a.t_s < b.t_s; });
  for (SceneEvent& event : events) event.film = clock.filmTimesOf(event.t_s, scene.time.duration_s);
  return events;
}

}  // namespace poinsot::scene
