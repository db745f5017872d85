// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "physics/motion.h"
#include "physics/unaligned_types.h"

namespace poinsot::physics {

/// Torque-free rotation of a rigid body in closed form, for any body, start and time, without stepping. Immutable
/// and thread-safe. at(t) costs the same for every t (0.15 to 0.55 us) and gives the same bits on every CPU.
///
/// Accuracy up to |omega t| = 1e14 rad, if the inputs are taken as exact doubles: the error of the attitude is
/// below 4e-15 rad, and the error of omega is below 4e-15 of the largest |omega| in the motion. Over 16 000
/// extreme bodies and starts, the largest errors were 1.2e-15 rad and 4.9e-16
/// (tests/physics/free_motion_hostile_test.cpp). If an input is rounded, no digit of the attitude is correct from
/// 4.5e15 rad on. Beyond 2^53 half periods of omega, 3e16 rad or more, the result is a different state of the same
/// motion.
class FreeMotion final : public Motion {
 public:
  /// Creates the motion that starts at t = 0.
  /// @param omega0_B angular velocity at t = 0, rad/s
  /// @param q0_WB attitude at t = 0, takes B to W; any nonzero quaternion
  /// @throws core::Error(kPhysics) for a non-finite omega0_B, a zero or non-finite quaternion, moments that differ
  /// by more than a factor of 1e20, or an angular momentum or energy beyond the range of numbers.
  FreeMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB);
  ~FreeMotion() override;
  FreeMotion(FreeMotion&&) noexcept;
  FreeMotion& operator=(FreeMotion&&) noexcept;

  /// Returns the state at motion time t_s (seconds, any sign). Its quaternion has w >= 0, so that its sign may
  /// change from one time to the next, although the rotation is continuous.
  /// @throws core::Error(kLimit) unless reaches(t_s).
  /// @pre the motion was not moved from.
  RigidBodyState at(double t_s) const override;
  using Motion::at;
  /// Returns whether at(t_s) has a result. All phases at t_s must be finite and at most kFarthestPhase_rad
  /// (motion.h).
  bool reaches(double t_s) const;

  const PrincipalAxes& axes() const override;
  double dissipation() const override { return 0; }
  /// Returns the angular momentum in W, kg·m²/s, which is a constant of the motion.
  const Eigen::Vector3d& L_W() const;
  /// Returns the kinetic energy of rotation, J (eq 12), which is a constant of the motion.
  double kineticEnergy() const;

 private:
  struct Solution;
  const Solution& solution() const;

  std::unique_ptr<const Solution> solution_;  // null after a move
};

}  // namespace poinsot::physics
