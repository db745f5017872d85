// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::app {
namespace {

/// Beyond this angle the phase of a free motion has lost digits (docs/physics.md, "Accuracy").
constexpr double kExactAngle_rad = 1e14;

}  // namespace

std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times) {
  const double farthest_s = std::max(std::abs(times.earliest_s()), std::abs(times.latest_s()));
  const double angle_rad = scene.motion.omega_B.norm() * farthest_s;
  if (!scene.motion.forcing.none() || !(angle_rad > kExactAngle_rad)) return {};
  return fmt::format(
      "at t = {:.6g} s the body has turned by {:.2g} rad; beyond {:.0g} rad the "
      "attitude is no longer exact to rounding",
      farthest_s, angle_rad, kExactAngle_rad);
}

}  // namespace poinsot::app
