// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/heavy_top.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// A symmetric top on its point under gravity alone, and how it is let go.
struct HeavyTopStart {
  physics::HeavyTop top;
  Eigen::Vector3d omega_P;  ///< rad/s
  Eigen::Vector3d up_P;     ///< unit
  double uneven = 0;        ///< by how much of themselves the moments across k differ

  double tilt_rad() const;  ///< of k from the vertical
  double spin() const;      ///< about k, rad/s
  physics::Nutation nutation() const { return top.nutation(omega_P, up_P); }
};

/// Empty for every other motion. Moments across k that differ by no more than a thousandth, as measured ones do,
/// are taken for symmetric.
std::optional<HeavyTopStart> heavyTopStart(const Scene& scene);

/// The start of the symmetric top that is nearest to the body, as if gravity alone acted: for estimates of a film.
/// Drag and dissipation may act, and the moments across k may differ by half of themselves if the spin is fast
/// enough to sleep, so that it averages over them. Empty where another torque acts.
std::optional<HeavyTopStart> nearlyHeavyTopStart(const Scene& scene);

}  // namespace poinsot::scene
