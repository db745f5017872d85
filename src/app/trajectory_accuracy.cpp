// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/run_condition.h"

namespace poinsot::app {
namespace {

/// Beyond this angle the phase of a free motion has lost digits (docs/physics.md, "Accuracy").
constexpr double kExactAngle_rad = 1e14;

/// Uncertainty of the attitude beyond that angle: an input's rounding of 2^-52 times it.
constexpr double kUncertain_rad = 0x1p-52 * kExactAngle_rad;

}  // namespace

std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times) {
  if (!scene.motion.forcing.none()) return {};
  const double farthest_s = std::max(std::abs(times.earliest_s()), std::abs(times.latest_s()));
  const double angle_rad = scene.motion.omega_B.norm() * farthest_s;
  if (angle_rad > kExactAngle_rad)
    return fmt::format(
        "at t = {:.6g} s the body has turned by {:.2g} rad; beyond {:.0g} rad the "
        "attitude is no longer exact to rounding",
        farthest_s, angle_rad, kExactAngle_rad);
  const physics::RunCondition condition = physics::runCondition(scene.body.axes, scene.motion.omega_B, farthest_s);
  if (!(condition.attitude_rad > kUncertain_rad)) return {};
  return fmt::format(
      "at t = {:.6g} s the attitude is uncertain by {:.2g} rad if the input is rounded: the motion is close to "
      "the "
      "separatrix, and {:.0f} digits mean something",
      farthest_s, condition.attitude_rad, std::floor(condition.digits));
}

}  // namespace poinsot::app
