// SPDX-License-Identifier: Apache-2.0
#include "physics/shape_inertia.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace poinsot::physics {
namespace {

constexpr double kHoopShare = 17.0 / 33;  // 0.17 kg of 0.33 kg

void requirePositive(double value, const char* name) {
  if (std::isfinite(value) && value > 0) return;
  throw core::Error(core::ErrorKind::kPhysics, fmt::format("{} must be positive and finite, got {}", name, value));
}

/// M (b² + c²)/n and cyclic.
PrincipalMoments threeLengthMoments(double mass_kg, const Eigen::Vector3d& lengths_m, double n, const char* name) {
  requirePositive(mass_kg, "mass");
  for (const double length : lengths_m) requirePositive(length, name);
  const Eigen::Vector3d squares = lengths_m.cwiseAbs2();
  return PrincipalMoments(
      mass_kg / n * Eigen::Vector3d(squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]));
}

}  // namespace

PrincipalMoments solidBoxMoments(double mass_kg, const Eigen::Vector3d& edges_m) {
  return threeLengthMoments(mass_kg, edges_m, 12, "edge of the box");
}

PrincipalMoments solidEllipsoidMoments(double mass_kg, const Eigen::Vector3d& semiAxes_m) {
  return threeLengthMoments(mass_kg, semiAxes_m, 5, "semi-axis of the ellipsoid");
}

PrincipalMoments solidCylinderMoments(double mass_kg, double radius_m, double height_m) {
  requirePositive(mass_kg, "mass");
  requirePositive(radius_m, "radius of the cylinder");
  requirePositive(height_m, "height of the cylinder");
  const double across = mass_kg * (3 * radius_m * radius_m + height_m * height_m) / 12;
  return PrincipalMoments({across, across, mass_kg * radius_m * radius_m / 2});
}

PrincipalMoments racketMoments(double mass_kg, double length_m, double width_m) {
  requirePositive(mass_kg, "mass");
  requirePositive(width_m, "width of the racket");
  requirePositive(length_m - width_m, "length of the racket less its width");
  const double R = width_m / 2, l = length_m - width_m, d = R + l / 2;
  const double hoop_kg = kHoopShare * mass_kg, handle_kg = (1 - kHoopShare) * mass_kg;
  const double aboutHandle = hoop_kg * R * R / 2;
  const double acrossHandle = aboutHandle + handle_kg * l * l / 12 + hoop_kg * handle_kg / mass_kg * d * d;
  return PrincipalMoments({aboutHandle, acrossHandle, aboutHandle + acrossHandle});
}

}  // namespace poinsot::physics
