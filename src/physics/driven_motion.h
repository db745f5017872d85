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

/// How a driven motion was worked out, and how good it is.
struct DrivenMotionReport {
  std::string method;
  int order = 0;              ///< of the step; 0 in closed form
  std::size_t steps = 0;      ///< over the whole span; 0 in closed form
  double shortestStep_s = 0;  ///< 0 in closed form
  double tolerance_rad = 0;   ///< asked for
  /// Of the attitude, over the whole span.
  double estimatedAttitudeError_rad = 0;
  /// The tolerance is not met: the estimate is the best that double precision allows for this motion.
  bool limitedByRounding = false;
  /// Largest change of kinetic plus potential energy over the span, as a part of the larger of the two; only where
  /// gravity alone acts, so that there should be none.
  std::optional<double> energyDrift;
};

/// The span of time a driven motion is wanted for, its ends in either order; 0 is always in it.
struct TimeSpan {
  double from_s = 0;
  double to_s = 0;
};

/// Rotation of a rigid body under torques, gravity, drag and energy loss: integrated once, then known at any time
/// of the span. Immutable and thread-safe; at(t) depends on t alone and gives the same bits on every CPU.
///
/// A splitting around the exact free rotation (splitting.h) in steps chosen to the tolerance (step_choice.h):
/// order 6 for torques and gravity, 8 with drag of unequal rates or dissipation. No torque, or drag of one rate
/// alone, is in closed form and knows no span.
class DrivenMotion final : public Motion {
 public:
  static constexpr double kDefaultTolerance_rad = 1e-12;
  static constexpr double kDefaultSteps = 2e6;  ///< of a run; with losses, where one takes longer, a fifth

  /// Start at t = 0. omega0_B in rad/s; q0_WB takes B to W, any nonzero quaternion. tolerance_rad: of the
  /// attitude, anywhere in the span; what cannot be reached in double precision is said in the report.
  /// @throws core::Error(kPhysics) for a start that FreeMotion refuses, a forcing that validate() refuses, a span
  /// or a tolerance that is not finite, a tolerance that is not positive; (kLimit) for a run of more steps than
  /// allowed. The integration calls core::checkInterruption().
  DrivenMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB,
               const Forcing& forcing, const TimeSpan& span, double tolerance_rad = kDefaultTolerance_rad,
               double allowedSteps = kDefaultSteps);
  ~DrivenMotion() override;
  DrivenMotion(DrivenMotion&&) noexcept;
  DrivenMotion& operator=(DrivenMotion&&) noexcept;

  /// @throws core::Error(kLimit) for a time outside the span, unless the motion is in closed form.
  /// @pre the motion was not moved from.
  RigidBodyState at(double t_s) const override;
  using Motion::at;  // of many times

  const PrincipalAxes& axes() const override;
  double dissipation() const override { return forcing().dissipation; }
  const Forcing& forcing() const;
  const DrivenMotionReport& report() const;
  /// Kinetic and potential energy, J (eq 12; potentialEnergy()).
  double totalEnergy(const RigidBodyState& state) const;

 private:
  struct Solution;
  const Solution& solution() const;

  std::unique_ptr<const Solution> solution_;  // null: moved from
};

}  // namespace poinsot::physics
