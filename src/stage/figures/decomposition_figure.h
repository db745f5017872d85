// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for omega of a free symmetric top as the diagonal of a parallelogram: omega_p along L, and -Omega_p k
/// along the axis (eq 32, 34).
class DecompositionFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) if the motion has no such parts.
  explicit DecompositionFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  physics::AngularVelocityParts parts_V(const PictureState& state) const;

 private:
  physics::PrecessionCones cones_;
  double scale_;
};

}  // namespace poinsot::stage
