// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// The plane through L and omega, a sheet as large as the two reach over the film; the axis k of a free symmetric
/// top lies in it (lecture, eq 34). None where L and omega are parallel.
class PlaneOfLFigure final : public Actor {
 public:
  explicit PlaneOfLFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// In order around it; empty where there is none.
  std::vector<Eigen::Vector3d> corners_V(const PictureState& state) const;

 private:
  double opacity_;
  double along_, across_;  // of the sheet, from the origin: beyond L; to either side
};

}  // namespace poinsot::stage
