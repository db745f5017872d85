// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "physics/forcing.h"
#include "physics/motion.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Method and accuracy of a computed driven motion. The estimated error is the largest error of the attitude in
/// the span. For a motion in closed form, order, steps and shortestStep_s are 0.
struct DrivenMotionReport {
  std::string method;
  int order = 0;
  std::size_t steps = 0;
  double shortestStep_s = 0;
  double tolerance_rad = 0;
  double estimatedAttitudeError_rad = 0;
  /// True if the tolerance is not met because of rounding errors. The estimated error is then the smallest that
  /// double precision allows for this motion.
  bool limitedByRounding = false;
  /// Largest change of the total energy over the span, relative to the largest kinetic or potential energy. Set
  /// only if gravity alone acts, because gravity conserves the total energy.
  std::optional<double> energyDrift;
};

/// Span of time for which a driven motion is computed. Its ends may be in either order; time 0 is always included.
struct TimeSpan {
  double from_s = 0;
  double to_s = 0;
};

/// Rotation of a rigid body under torques, gravity, drag and energy loss. The constructor integrates the motion
/// once; at(t) then returns the state at any time of the span. Immutable and thread-safe: at(t) depends on t alone
/// and gives the same bits on every CPU.
///
/// The method is a splitting around the exact free rotation (splitting.h), in steps chosen to meet the tolerance
/// (step_choice.h). Its order is 6 for torques and gravity, and 8 with drag of unequal rates or with dissipation.
/// A motion without forcing, or only with drag of equal rates, has a closed form and is not limited to a span.
class DrivenMotion final : public Motion {
 public:
  static constexpr double kDefaultTolerance_rad = 1e-12;
  /// Default limit on the number of steps. With losses, only a fifth of this number is allowed, because such steps
  /// take longer to compute.
  static constexpr double kDefaultSteps = 2e6;

  /// Integrates the motion that starts at t = 0 over the span. Calls core::checkInterruption() at each step.
  /// @param omega0_B angular velocity at t = 0, rad/s
  /// @param q0_WB attitude at t = 0, takes B to W; any nonzero quaternion
  /// @param tolerance_rad accepted error of the attitude at any time of the span; if double precision cannot reach
  /// it, report() shows this
  /// @throws core::Error(kPhysics) for a start that FreeMotion rejects, a forcing that validate() rejects, a span
  /// or a tolerance that is not finite, a tolerance that is not positive, or a motion that leaves the range of
  /// numbers; (kLimit) for more steps than allowed.
  DrivenMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB,
               const Forcing& forcing, const TimeSpan& span, double tolerance_rad = kDefaultTolerance_rad,
               double allowedSteps = kDefaultSteps);
  ~DrivenMotion() override;
  DrivenMotion(DrivenMotion&&) noexcept;
  DrivenMotion& operator=(DrivenMotion&&) noexcept;

  /// Returns the state at motion time t_s (seconds).
  /// @throws core::Error(kLimit) for a time outside the span, unless the motion is in closed form.
  /// @pre the motion was not moved from.
  RigidBodyState at(double t_s) const override;
  using Motion::at;

  const PrincipalAxes& axes() const override;
  double dissipation() const override { return forcing().dissipation; }
  const DrivenMotion* driven() const override { return this; }
  const Forcing& forcing() const;
  const DrivenMotionReport& report() const;
  /// Returns the span for which the motion was computed, with from_s <= 0 <= to_s. It is infinite for a motion in
  /// closed form.
  TimeSpan span() const;
  /// Returns kinetic plus potential energy, J (eq 12; potentialEnergy()).
  double totalEnergy(const RigidBodyState& state) const;

 private:
  struct Solution;
  const Solution& solution() const;

  std::unique_ptr<const Solution> solution_;  // null after a move
};

}  // namespace poinsot::physics
