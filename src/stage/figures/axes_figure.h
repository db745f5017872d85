// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the inertial axes x, y, z.
class SpaceAxesFigure final : public Actor {
 public:
  explicit SpaceAxesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  double length_;
};

/// Actor for the components of omega along the principal axes, and for the box whose diagonal is omega.
class ComponentsFigure final : public Actor {
 public:
  explicit ComponentsFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns a matrix whose columns are the components as vectors, in picture lengths. The sum of the columns is
  /// omega.
  Eigen::Matrix3d components_V(const PictureState& state) const;

 private:
  double scale_;
};

}  // namespace poinsot::stage
