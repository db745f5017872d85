// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for a stroboscopic picture: the body in pale colours at other times of the film. Each pose is drawn a
/// step away from the previous pose. Poses of a thrown body are drawn where the body is at their times.
class GhostsFigure final : public Actor {
 public:
  explicit GhostsFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  struct Pose {
    double filmTime_s;
    Eigen::Matrix3d R_WB;
    /// Position relative to the body, computed for the camera's direction at the start of the film. If the body
    /// moves through the view: position relative to the origin of space.
    Eigen::Vector3d place_V;
  };
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  const BodyFigure& body_;
  Eigen::Vector3d place_V(const Pose& pose, const PictureState& state) const;

  double scale_, strength_;
  bool moves_;
  double flightScale_;
  std::vector<Pose> poses_;
};

}  // namespace poinsot::stage
