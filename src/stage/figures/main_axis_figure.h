// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the axis k of the body (symmetric_top.h), drawn as an arrow with a label.
class MainAxisFigure final : public Actor {
 public:
  explicit MainAxisFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  Eigen::Vector3d tip_P_;
};

}  // namespace poinsot::stage
