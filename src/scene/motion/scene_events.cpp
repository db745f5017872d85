// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/scene_events.h"

#include <algorithm>

#include "physics/motion_events.h"
#include "scene/motion/make_motion.h"

namespace poinsot::scene {
namespace {

bool within(double t_s, const physics::TimeSpan& span) {
  return std::min(span.from_s, span.to_s) <= t_s && t_s <= std::max(span.from_s, span.to_s);
}

/// Returns the times at which a body under forces is highest, in the span: the velocity along gravity changes from
/// rising to falling. Finds them between samples, and bisects.
std::vector<double> highestPoints(const physics::FlightPath& path, const physics::TimeSpan& span) {
  constexpr int kSamples = 4096, kBisections = 60;
  const Eigen::Vector3d& g = path.gravityAlone().gravity_W;
  const auto [first, last] = std::minmax(span.from_s, span.to_s);
  const auto rises = [&](double t) { return path.velocityAt(t).dot(g) < 0; };
  std::vector<double> tops;
  bool before = rises(first);
  double begin = first;
  for (int i = 1; i <= kSamples; ++i) {
    const double end = i == kSamples ? last : first + (last - first) / kSamples * i;
    const bool after = rises(end);
    if (before && !after) {
      double low = begin, high = end;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = low + 0.5 * (high - low);
        (rises(middle) ? low : high) = middle;
      }
      tops.push_back(high);
    }
    before = after;
    begin = end;
  }
  return tops;
}

/// Adds the highest points of a flight. Without forces, also adds the return to the height of the start.
void addFlight(const Scene& scene, const physics::Motion& motion, const physics::TimeSpan& span,
               std::vector<SceneEvent>& events) {
  if (!scene.motion.flight || scene.motion.flight->gravity_W.isZero(0)) return;
  if (const auto path = flightPath(scene, motion); path->hasForces()) {
    for (const double top_s : highestPoints(*path, span)) events.push_back({kHighestPoint, top_s, {}});
    return;
  }
  const double top_s = scene.motion.flight->top().t_s;
  if (within(top_s, span)) events.push_back({kHighestPoint, top_s, {}});
  if (top_s > 0 && within(2 * top_s, span)) events.push_back({kCatch, 2 * top_s, {}});
}

}  // namespace

std::vector<SceneEvent> sceneEvents(const Scene& scene, const physics::Motion& motion, const FilmClock& clock,
                                    const physics::TimeSpan& span) {
  std::vector<SceneEvent> events;
  if (!scene.motion.rolling)
    for (const physics::MotionEvent& event : physics::motionEvents(motion, scene.motion.forcing, span))
      events.push_back({static_cast<int>(event.kind), event.t_s, {}});
  addFlight(scene, motion, span, events);
  const bool backwards = span.to_s < span.from_s;
  std::ranges::stable_sort(
      events, [&](const SceneEvent& a, const SceneEvent& b) { return backwards ? a.t_s > b.t_s : a.t_s < b.t_s; });
  for (SceneEvent& event : events) event.film = clock.filmTimesOf(event.t_s, scene.time.duration_s);
  return events;
}

}  // namespace poinsot::scene
