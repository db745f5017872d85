// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/actor.h"

namespace poinsot::stage {

/// The axis k of the body (symmetric_top.h), an arrow with its name.
class MainAxisFigure final : public Actor {
 public:
  explicit MainAxisFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  Eigen::Vector3d tip_P_;
};

/// The arc from L to k, theta of the lecture's eq 18; under gravity from the vertical, which is drawn too.
class ThetaFigure final : public Actor {
 public:
  explicit ThetaFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// From the one direction to the other, along a great circle. Empty where L is 0.
  std::vector<Eigen::Vector3d> arc(const PictureState& state) const;

 private:
  Eigen::Vector3d from_V(const PictureState& state) const;

  Eigen::Vector3d k_P_;
  bool fromVertical_;
  double radius_;
};

}  // namespace poinsot::stage
