// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/abi.h"
#include "core/expect.h"

namespace poinsot::physics {

/// Principal moments of inertia about the centre of mass, kg·m², in the order of the body's axes (any order).
/// Valid by construction: finite, positive, and no moment above the sum of the other two.
class PrincipalMoments {
 public:
  /// Takes three moments, kg·m². @throws core::Error(kPhysics) naming the violated condition and the values.
  PrincipalMoments(double I1, double I2, double I3);
  /// Takes the moments from a vector. The constructor is a template, so that three numbers in braces do not select
  /// it.
  /// @throws core::Error(kPhysics) as PrincipalMoments(double, double, double) does.
  template <typename Derived>
  explicit PrincipalMoments(const Eigen::EigenBase<Derived>& moments) : moments_(moments.derived()) {
    check();
  }

  const Eigen::Vector3d& values() const { return moments_; }
  /// @pre axis is 0, 1 or 2.
  double operator[](int axis) const {
    POINSOT_EXPECT(axis >= 0 && axis < 3);
    return moments_[axis];
  }

  /// Returns the axes from the smallest moment to the largest; axes of equal moments keep their order.
  std::array<int, 3> ascendingAxes() const;

  /// Returns I·omega, the angular momentum along the principal axes, kg·m²/s.
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& omega_P) const;

  /// Returns the kinetic energy T = ½ ω·I·ω, J (eq 12).
  double kineticEnergy(const Eigen::Vector3d& omega_P) const;

 private:
  void check() const;

  Eigen::Vector3d moments_;
};

static_assert(core::laidOut<PrincipalMoments, 24>());

}  // namespace poinsot::physics
