// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

class AngularMomentumFigure final : public Actor {
 public:
  explicit AngularMomentumFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  double scale_;
};

class AngularVelocityFigure final : public Actor {
 public:
  explicit AngularVelocityFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  void addName(const Canvas& canvas, const Eigen::Vector3d& tip_V) const;

  double scale_;
  bool inConstruction_;  // true if the plane or the ellipsoid is shown
};

/// Actor for the torque on the body, drawn as an arrow with a label. The length is relative to the largest torque
/// in the film. A torque of zero is not drawn.
class TorqueFigure final : public Actor {
 public:
  explicit TorqueFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  double scale_;  // picture lengths per N·m
};

}  // namespace poinsot::stage
