// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// Largest phase at which a motion has a state, rad; beyond it, the products that reduce a phase would overflow
/// (double_double.h). Three phases grow with t: of omega, of L over the middle moment, and of the polhode. None
/// exceeds 2 |omega t|, so every motion has a state if |omega t| is at most half of this.
inline constexpr double kFarthestPhase_rad = 1e290;

/// Largest phase |omega t| at which free motion is exact to rounding, rad (free_motion.h).
inline constexpr double kExactPhase_rad = 1e14;

/// Reports that a motion has no state at a time. @throws core::Error(kLimit) always.
[[noreturn]] void refuseTime(double t_s);

/// Rotation of a rigid body about its centre of mass or a fixed point, available at any time. Immutable and
/// thread-safe: at(t) depends on t alone.
class Motion {
 public:
  virtual ~Motion() = default;

  /// Returns the state at motion time t_s (seconds), with finite numbers. Of q and -q, the state has the one with
  /// w >= 0.
  /// @throws core::Error(kLimit) for a time that is not finite, beyond kFarthestPhase_rad, beyond the range of
  /// numbers or outside the span of a driven motion.
  /// @pre the motion was not moved from.
  virtual RigidBodyState at(double t_s) const = 0;
  /// Returns one state for each time; the times may be in any order.
  /// @throws core::Error(kLimit) as at(double) does, naming the index of the first such time.
  std::vector<RigidBodyState> at(std::span<const double> times_s) const;

  virtual const PrincipalAxes& axes() const = 0;

  /// Returns the energy loss alpha at constant L, s/(kg·m²) (forcing.h); 0 if there is no such loss.
  virtual double dissipation() const = 0;

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion(Motion&&) = default;
  Motion& operator=(const Motion&) = default;
  Motion& operator=(Motion&&) = default;
};

/// Returns the rate at which the attitude turns, along the body's axes B, rad/s: R' = R [rate]. The rate is omega
/// + alpha m × omega with m = I omega, so that energy is lost at constant L (docs/physics.md, "Driven motion").
/// Without dissipation, the rate is omega. @param state a state of this motion
Eigen::Vector3d turningRate_B(const Motion& motion, const RigidBodyState& state);
/// Returns turningRate_B() along the inertial axes W. Without dissipation, this is omega_W, bit by bit.
Eigen::Vector3d turningRate_W(const Motion& motion, const RigidBodyState& state);

}  // namespace poinsot::physics
