// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the two parts of omega of a free symmetric top: omega_p along L, and -Omega_p k along the axis k (eq
/// 32, 34). The parts are the sides of a parallelogram whose diagonal is omega.
class DecompositionFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
  explicit DecompositionFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  physics::AngularVelocityParts parts_V(const PictureState& state) const;

 private:
  physics::PrecessionCones cones_;
  double scale_;
};

}  // namespace poinsot::stage
