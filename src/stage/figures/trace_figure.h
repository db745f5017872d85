// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the path of a body point on a sphere about the fixed point, such as the loops of a heavy top's
/// nutation. If the body moves through the view, the path is drawn in space without a sphere. The travelled part
/// is strong, and the part to come is faint.
class TraceFigure final : public Actor {
 public:
  explicit TraceFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  Eigen::Vector3d growsFrom(const PictureState& state) const override { return point_V(state); }

  Eigen::Vector3d point_V(const PictureState& state) const { return state.R_VB * point_B_; }
  double radius() const { return point_B_.norm(); }

 private:
  std::vector<Eigen::Vector3d> path_W(double from_s, double to_s) const;
  Eigen::Vector3d at_W(double played_s) const;
  void addPath(const Canvas& canvas, const PictureState& state, double from_s, double to_s,
               const draw::Color& color, double width, double lift) const;

  const PictureMotion& motion_;
  Eigen::Vector3d point_B_;  // vector from the fixed point to the traced point, in picture lengths
  double flightScale_, opacity_;
  bool future_;
  double step_s_;
};

}  // namespace poinsot::stage
