// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/heavy_top.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Largest relative difference of the two moments across the axis of a symmetric top: measured moments are never
/// exactly equal.
inline constexpr double kMostUneven = 1e-3;

/// Start of a heavy top: a symmetric body with a fixed point on its axis k, under gravity alone.
struct HeavyTopStart {
  physics::HeavyTop top;
  Eigen::Vector3d omega_P;  ///< angular velocity, rad/s
  Eigen::Vector3d up_P;     ///< upward vertical, unit vector
  double uneven = 0;        ///< difference of the two moments perpendicular to k, relative to their mean

  double tilt_rad() const;  ///< angle between k and the vertical
  double spin() const;      ///< component of omega along k, rad/s
  physics::Nutation nutation() const { return top.nutation(omega_P, up_P); }
};

/// Returns the start of the scene's motion if the body is a heavy top; otherwise nullopt. The two moments
/// perpendicular to k may differ by kMostUneven.
std::optional<HeavyTopStart> heavyTopStart(const Scene& scene);

/// Returns the start of the symmetric top that is most similar to the body, for estimates about a film. Ignores
/// drag and dissipation. The two moments perpendicular to k may differ by half if the spin is at least that of a
/// sleeping top, because a fast spin averages over the difference. Returns nullopt if another torque acts.
std::optional<HeavyTopStart> nearlyHeavyTopStart(const Scene& scene);

}  // namespace poinsot::scene
