// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "physics/principal_axes.h"
#include "physics/rigid_body_state.h"

namespace poinsot::physics {

/// The farthest phase at which a motion has a state, rad: the products that reduce it stay doubles
/// (double_double.h). Three phases grow with t: of omega, of L over the middle moment, and of the polhode. None
/// exceeds 2 |omega t|, so every motion has a state while |omega t| is at most half of this.
inline constexpr double kFarthestPhase_rad = 1e290;

/// The phase |omega t| up to which free motion is exact to rounding, rad (free_motion.h).
inline constexpr double kExactPhase_rad = 1e14;

/// @throws core::Error(kLimit), always: the motion has no state at this time.
[[noreturn]] void refuseTime(double t_s);

/// The rotation of a rigid body about its centre of mass or a fixed point, known at any time. Immutable and
/// thread-safe: at(t) depends on t alone.
class Motion {
 public:
  virtual ~Motion() = default;

  /// State at motion time t_s (seconds), all numbers finite. Of q and -q the one with w >= 0.
  /// @throws core::Error(kLimit) for a time that is not finite, one beyond kFarthestPhase_rad or beyond the range
  /// of numbers, and one outside the span of a driven motion.
  /// @pre the motion was not moved from.
  virtual RigidBodyState at(double t_s) const = 0;
  /// Returns the states at many times, in any order, one for each.
  /// @throws core::Error(kLimit) as at(double) does, naming the index of the first such time.
  std::vector<RigidBodyState> at(std::span<const double> times_s) const;

  virtual const PrincipalAxes& axes() const = 0;

  /// Energy loss alpha at constant L, s/(kg·m²) (forcing.h); 0 where nothing is lost so.
  virtual double dissipation() const = 0;

 protected:
  Motion() = default;
  Motion(const Motion&) = default;
  Motion(Motion&&) = default;
  Motion& operator=(const Motion&) = default;
  Motion& operator=(Motion&&) = default;
};

/// Rate at which the attitude turns, along the body's axes B, rad/s: R' = R [rate]. It is omega + alpha m × omega,
/// m = I omega, so that energy is lost at constant L (docs/physics.md, "Driven motion"); omega itself without
/// dissipation. @param state  a state of this motion.
Eigen::Vector3d turningRate_B(const Motion& motion, const RigidBodyState& state);
/// The same vector along the inertial axes W; omega_W itself, bit by bit, without dissipation.
Eigen::Vector3d turningRate_W(const Motion& motion, const RigidBodyState& state);

}  // namespace poinsot::physics
