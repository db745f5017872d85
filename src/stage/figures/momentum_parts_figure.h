// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the two parts of L of a free symmetric top, L = I1 omega + (I3 - I1) omega_3 k (eq 36), head to tail.
/// The second part points along k for an oblate body, and against k for a prolate one.
class MomentumPartsFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
  explicit MomentumPartsFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns I1 omega and (I3 - I1) omega_3 k, in picture lengths. Their sum is L.
  struct Parts {
    Eigen::Vector3d alongOmega, alongAxis;
  };
  Parts parts_V(const PictureState& state) const;

 private:
  physics::PrecessionCones cones_;
  double across_, difference_;  // I1 and I3 - I1, times the scale of L
  double omegaScale_;           // 0 if omega is not drawn
};

}  // namespace poinsot::stage
