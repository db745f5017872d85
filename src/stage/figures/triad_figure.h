// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Returns the length of the axes i, j, k in the picture, if they are drawn.
double triadLength(const Setting& setting);

/// Actor for the lecture's axes i, j, k of a free symmetric top (eq 19), with i in the plane of L and k. Also
/// draws omega_1 along i and omega_3 along k, the sides of a rectangle whose diagonal is omega.
class TriadFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is that of a free symmetric top with L not along k.
  explicit TriadFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the axes i, j, k as columns, in picture lengths.
  Eigen::Matrix3d axes_V(const PictureState& state) const;
  /// Returns omega_1 i and omega_3 k, in picture lengths. Their sum is omega.
  struct Components {
    Eigen::Vector3d alongI, alongK;
  };
  Components components_V(const PictureState& state) const;

 private:
  void addComponents(const Canvas& canvas, const PictureState& state) const;

  physics::PrecessionCones cones_;
  double length_, omegaScale_;
  bool components_;
  bool namesK_;  // false if show.main_axis draws the name too
};

}  // namespace poinsot::stage
