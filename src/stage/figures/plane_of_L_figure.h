// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the plane through L and omega, drawn as a sheet that is large enough for L, omega and the axis k
/// throughout the film. The axis k of a free symmetric top lies in this plane (lecture, eq 34). Draws nothing if L
/// and omega are parallel.
class PlaneOfLFigure final : public Actor {
 public:
  explicit PlaneOfLFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the corners in order around the sheet; empty if L and omega do not define a plane.
  std::vector<Eigen::Vector3d> corners_V(const PictureState& state) const;

 private:
  double opacity_;
  double along_, across_;  // extent of the sheet from the origin: along L, and to each side of L
};

}  // namespace poinsot::stage
