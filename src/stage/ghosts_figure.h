// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/actor.h"

namespace poinsot::stage {

/// The body as it is at other times of the film, pale, each pose a step from the one before: a stroboscopic
/// picture.
class GhostsFigure final : public Actor {
 public:
  explicit GhostsFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  struct Pose {
    Eigen::Matrix3d R_WB;
    Eigen::Vector3d place_V;  ///< from the body, as the camera stands at the film's start
  };
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  const BodyFigure& body_;
  double scale_, strength_;
  std::vector<Pose> poses_;
};

}  // namespace poinsot::stage
