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

/// Method and accuracy of a computed driven motion. Errors are those of the attitude over the whole span. In
/// closed form, order, steps and shortestStep_s are 0.
struct DrivenMotionReport {
  std::string method;
  int order = 0;
  std::size_t steps = 0;
  double shortestStep_s = 0;
  double tolerance_rad = 0;
  double estimatedAttitudeError_rad = 0;
  /// True if the tolerance is not met: the estimate is the best that double precision allows for this motion.
  bool limitedByRounding = false;
  /// Largest change of kinetic plus potential energy over the span, relative to the larger of the two. Set only if
  /// gravity alone acts, which conserves the sum.
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
/// (step_choice.h). Its order is 6 for torques and gravity, 8 with drag of unequal rates or dissipation. A motion
/// without torque, or with drag of one rate alone, is in closed form and not limited to a span.
class DrivenMotion final : public Motion {
 public:
  static constexpr double kDefaultTolerance_rad = 1e-12;
  /// Default limit of the steps of a run. With losses, whose steps take longer, a fifth of the limit applies.
  static constexpr double kDefaultSteps = 2e6;

  /// Integrates the motion that starts at t = 0 over the span; calls core::checkInterruption() meanwhile.
  /// @param omega0_B angular velocity at t = 0, rad/s
  /// @param q0_WB attitude at t = 0, takes B to W; any nonzero quaternion
  /// @param tolerance_rad for the attitude, anywhere in the span; report() shows if double precision does not
  /// reach it
  /// @throws core::Error(kPhysics) for a start that FreeMotion refuses, a forcing that validate() refuses, a span
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
  const Forcing& forcing() const;
  const DrivenMotionReport& report() const;
  /// Returns kinetic plus potential energy, J (eq 12; potentialEnergy()).
  double totalEnergy(const RigidBodyState& state) const;

 private:
  struct Solution;
  const Solution& solution() const;

  std::unique_ptr<const Solution> solution_;  // null after a move
};

}  // namespace poinsot::physics
