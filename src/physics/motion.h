// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Largest phase at which a motion has a state, rad. Beyond it, the reduction of a phase would overflow
/// (double_double.h). Three phases grow with time: the angle of omega, L t divided by the middle moment, and the
/// phase of the polhode. None exceeds 2 |omega t|. Every motion therefore has a state if |omega t| is at most half
/// of this value.
inline constexpr double kFarthestPhase_rad = 1e290;

/// Largest phase |omega t| at which free motion is exact to rounding, rad (free_motion.h).
inline constexpr double kExactPhase_rad = 1e14;

/// Reports that a motion has no state at a time. @throws core::Error(kLimit) always.
[[noreturn]] void refuseTime(double t_s);

class DrivenMotion;

/// Rotation of a rigid body about its centre of mass or a fixed point, available at any time. Immutable and
/// thread-safe: at(t) depends on t alone.
class Motion {
 public:
  virtual ~Motion() = default;

  /// Returns the state at motion time t_s (seconds). All its numbers are finite, and its quaternion has w >= 0.
  /// @throws core::Error(kLimit) for a time that is not finite, beyond kFarthestPhase_rad, beyond the range of
  /// numbers or outside the span of a driven motion.
  /// @pre the motion was not moved from.
  virtual RigidBodyState at(double t_s) const = 0;
  /// Returns one state for each time. The times may be in any order.
  /// @throws core::Error(kLimit) as at(double) does, naming the index of the first time without a state.
  std::vector<RigidBodyState> at(std::span<const double> times_s) const;

  virtual const PrincipalAxes& axes() const = 0;

  /// Returns the rate alpha of energy loss at constant L, s/(kg·m²) (forcing.h), or 0 if the motion has no such
  /// loss.
  virtual double dissipation() const = 0;

  /// Returns the motion as a driven motion, which has a forcing, or null for other motions. A wrapper returns the
  /// motion that it wraps.
  virtual const DrivenMotion* driven() const { return nullptr; }

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion(Motion&&) = default;
  Motion& operator=(const Motion&) = default;
  Motion& operator=(Motion&&) = default;
};

/// Returns the rate at which the attitude turns, in B, rad/s: R' = R [rate]. Without dissipation, the rate is
/// omega. With dissipation, it is omega + alpha m × omega, where m = I omega, so that energy is lost at constant L
/// (docs/physics.md, "Driven motion").
/// @param state a state of this motion
Eigen::Vector3d turningRate_B(const Motion& motion, const RigidBodyState& state);
/// Returns turningRate_B() in the inertial axes W. Without dissipation, the result is exactly omega_W.
Eigen::Vector3d turningRate_W(const Motion& motion, const RigidBodyState& state);

}  // namespace poinsot::physics
