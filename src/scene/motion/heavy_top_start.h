// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/heavy_top.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Symmetric top on its point under gravity alone, and its start.
struct HeavyTopStart {
  physics::HeavyTop top;
  Eigen::Vector3d omega_P;  ///< rad/s
  Eigen::Vector3d up_P;     ///< unit vector
  double uneven = 0;        ///< difference of the moments across k, relative to the moments

  double tilt_rad() const;  ///< angle of k from the vertical
  double spin() const;      ///< rate about k, rad/s
  physics::Nutation nutation() const { return top.nutation(omega_P, up_P); }
};

/// Returns the start of a heavy top; empty for any other motion. Moments across k count as equal if they differ by
/// at most a thousandth, which covers measured values.
std::optional<HeavyTopStart> heavyTopStart(const Scene& scene);

/// Returns the start of the symmetric top nearest to the body under gravity alone, for estimates about a film.
/// Ignores drag and dissipation. The moments across k may differ by up to half of themselves if the spin is fast
/// enough to sleep, because a fast spin averages over the difference. Empty if another torque acts.
std::optional<HeavyTopStart> nearlyHeavyTopStart(const Scene& scene);

}  // namespace poinsot::scene
