// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/motion.h"
#include "physics/run_condition.h"

namespace poinsot::reference {
namespace {

constexpr double kRounding = 0x1p-52;  // of an input, as a part of it

/// Uncertainty of the attitude at that phase: the rounding of omega times it.
constexpr double kUncertain_rad = kRounding * physics::kExactPhase_rad;

/// The phase at which that is a radian: 4.5e15 rad.
constexpr double kLastPhase_rad = 1 / kRounding;

/// Uncertainty over that of omega's rounding alone, from which on the separatrix is to blame: far from it, moments
/// (1, 2, 3) and omega (1, 1, 1) give 3.3; closer, the ratio grows as the inverse of the distance.
constexpr double kCloseToSeparatrix = 100;

std::string farTurnNote(double t_s, double angle_rad) {
  const std::string turned = fmt::format("at t = {:.6g} s the body has turned by {:.2g} rad; ", t_s, angle_rad);
  if (angle_rad < kLastPhase_rad)
    return turned +
           fmt::format("beyond {:.0g} rad the attitude is no longer exact to rounding", physics::kExactPhase_rad);
  return turned + fmt::format(
                      "beyond {:.2g} rad the attitude is meaningless, because the rounding of omega alone "
                      "turns the body by more than a radian",
                      kLastPhase_rad);
}

std::string uncertaintyNote(double t_s, double angle_rad, const physics::RunCondition& condition) {
  const bool close = condition.attitude_rad > kCloseToSeparatrix * kRounding * (1 + angle_rad);
  return fmt::format(
      "at t = {:.6g} s the attitude is uncertain by {:.2g} rad if the input is rounded: {}, and {} "
      "of the attitude is meaningful",
      t_s, condition.attitude_rad,
      close ? "the motion is close to the separatrix" : "the run amplifies the rounding",
      condition.digits < 1 ? "no digit" : "one digit");
}

}  // namespace

std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times) {
  if (!scene.motion.forcing.none()) return {};
  const double farthest_s = std::max(std::abs(times.earliest_s()), std::abs(times.latest_s()));
  const double angle_rad = scene.motion.omega_B.norm() * farthest_s;
  if (angle_rad > physics::kExactPhase_rad) return farTurnNote(farthest_s, angle_rad);
  const physics::RunCondition condition = physics::runCondition(scene.body.axes, scene.motion.omega_B, farthest_s);
  if (!(condition.attitude_rad > kUncertain_rad)) return {};
  return uncertaintyNote(farthest_s, angle_rad, condition);
}

}  // namespace poinsot::reference
