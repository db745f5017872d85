// SPDX-License-Identifier: Apache-2.0
#include "physics/mass_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "physics/double_double.h"
#include "physics/inertia_tensor.h"
#include "physics/require_finite.h"
#include "physics/symmetric_eigen.h"

namespace poinsot::physics {
namespace {

void requirePlace(double mass_kg, const Eigen::Vector3d& centre_B) {
  if (!std::isfinite(mass_kg) || mass_kg <= 0)
    throw core::physicsError(fmt::format("mass must be positive and finite, got {}", mass_kg));
  requireFinite(centre_B, "centre of mass", " m");
}

/// Checks that matter can have a tensor. Its principal moments, such as ∫(y² + z²)dm, must not be negative, and
/// none may exceed the sum of the other two.
/// @param scale_kgm2 moment whose rounding error is accepted, if it is larger than the tensor's own moments
void requireMatter(const Eigen::Matrix3d& inertia_B, double scale_kgm2) {
  const SymmetricEigen eigen = symmetricEigen(inertia_B);
  std::array moments{toDouble(eigen.values[0]), toDouble(eigen.values[1]), toDouble(eigen.values[2])};
  std::ranges::sort(moments);
  const auto& [low, middle, high] = moments;
  const double slack = kTensorSlack * std::max(high, scale_kgm2);
  if (low >= -slack && high <= low + middle + slack) return;
  throw core::physicsError(
      fmt::format("{}, got principal moments ({}, {}, {}) kg·m²",
                  low < -slack ? "moments of inertia must not be negative"
                               : "no moment may exceed the sum of the other two (no body has these values)",
                  low, middle, high));
}

/// Sum of the inertia tensors of several pieces about a common point (eq 14). A piece adds its tensor and M(a² - a
/// a), where a points from the common point to the piece's centre of mass.
class DisplacedSum {
 public:
  void add(const MassProperties& piece, const Eigen::Vector3d& point_B) {
    add(piece.inertia_B(), piece.mass_kg(), piece.centre_B(), point_B);
  }

  /// Adds a piece: its tensor and M(a² - a a). A negative mass subtracts the second term.
  void add(const Eigen::Matrix3d& inertia_B, double mass_kg, const Eigen::Vector3d& centre_B,
           const Eigen::Vector3d& point_B) {
    const std::array a{twoSum(centre_B[0], -point_B[0]), twoSum(centre_B[1], -point_B[1]),
                       twoSum(centre_B[2], -point_B[2])};
    const DoubleDouble M = mass_kg;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      diagonal_[i] += M * (a[j] * a[j] + a[k] * a[k]) + entry(inertia_B, i, i);
      opposite_[i] += entry(inertia_B, j, k) - M * (a[j] * a[k]);
    }
  }

  Eigen::Matrix3d tensor() const {
    Eigen::Matrix3d I;
    for (std::size_t i = 0; i < 3; ++i) {
      const int p = static_cast<int>(i), q = (p + 1) % 3, r = (p + 2) % 3;
      I(p, p) = toDouble(diagonal_[i]);
      I(q, r) = I(r, q) = toDouble(opposite_[i]);
    }
    return I;
  }

 private:
  static DoubleDouble entry(const Eigen::Matrix3d& inertia_B, std::size_t i, std::size_t j) {
    return inertia_B(static_cast<int>(i), static_cast<int>(j));
  }

  std::array<DoubleDouble, 3> diagonal_, opposite_;  // I_xx, I_yy, I_zz and I_yz, I_zx, I_xy
};

}  // namespace

MassProperties::MassProperties(double mass_kg, const Eigen::Vector3d& centre_B, const Eigen::Matrix3d& inertia_B)
    : MassProperties(mass_kg, centre_B, inertia_B, 0) {}

MassProperties::MassProperties(double mass_kg, const Eigen::Vector3d& centre_B, const Eigen::Matrix3d& inertia_B,
                               double scale_kgm2)
    : mass_kg_(mass_kg), centre_B_(centre_B), inertia_B_(symmetricTensor(inertia_B)) {
  requirePlace(mass_kg_, centre_B_);
  requireMatter(inertia_B_, scale_kgm2);
}

MassProperties MassProperties::fromInertiaAbout(const Eigen::Vector3d& point_B, double mass_kg,
                                                const Eigen::Vector3d& centre_B,
                                                const Eigen::Matrix3d& inertia_B) {
  DisplacedSum sum;
  sum.add(symmetricTensor(inertia_B), -mass_kg, centre_B, point_B);
  return {mass_kg, centre_B, sum.tensor(), inertia_B.cwiseAbs().maxCoeff()};
}

MassProperties MassProperties::ofPoint(double mass_kg, const Eigen::Vector3d& position_B) {
  return {mass_kg, position_B, Eigen::Matrix3d::Zero()};
}

Eigen::Matrix3d MassProperties::inertiaAbout(const Eigen::Vector3d& point_B) const {
  DisplacedSum sum;
  sum.add(*this, point_B);
  const Eigen::Matrix3d inertia = sum.tensor();
  if (!inertia.allFinite())
    throw core::physicsError(fmt::format("the inertia about ({}, {}, {}) m is beyond the range of numbers",
                                         point_B[0], point_B[1], point_B[2]));
  return inertia;
}

MassProperties MassProperties::moved(const Quaternion& q, const Eigen::Vector3d& offset_B) const {
  return {mass_kg_, turnedVector(q, centre_B_) + offset_B, turnedTensor(q, inertia_B_)};
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) { return combined({a, b}); }

MassProperties combined(const std::vector<MassProperties>& pieces) {
  POINSOT_EXPECT(!pieces.empty());
  DoubleDouble mass;
  std::array<DoubleDouble, 3> moment;
  for (const MassProperties& piece : pieces) {
    mass += piece.mass_kg();
    for (std::size_t i = 0; i < 3; ++i)
      moment[i] += DoubleDouble(piece.mass_kg()) * piece.centre_B()[static_cast<int>(i)];
  }
  const Eigen::Vector3d centre_B(toDouble(moment[0] / mass), toDouble(moment[1] / mass),
                                 toDouble(moment[2] / mass));
  DisplacedSum sum;
  for (const MassProperties& piece : pieces) sum.add(piece, centre_B);
  return {toDouble(mass), centre_B, sum.tensor()};
}

}  // namespace poinsot::physics
