// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the table on which a cone rolls: a level sheet with a grid, the line of contact, and the circle on
/// which the base touches the table.
class TableFigure final : public Actor {
 public:
  /// @pre the motion of the setting is that of a rolling cone.
  explicit TableFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the end of the line of contact on the rim of the base. The line begins at the origin.
  Eigen::Vector3d contactEnd_V(const PictureState& state) const;
  /// Returns half the edge of the table, in picture lengths.
  double halfEdge() const { return halfEdge_; }

 private:
  draw::GridPlane sheet(const Canvas& canvas, const PictureState& state) const;

  physics::RollingCone cone_;
  double slant_;  // length of the line of contact, in picture lengths
  double halfEdge_;
};

}  // namespace poinsot::stage
