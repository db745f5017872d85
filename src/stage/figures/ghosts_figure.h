// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// The body as it is at other times of the film, pale, each pose a step from the one before, or where a
/// thrown body was then: a stroboscopic picture.
class GhostsFigure final : public Actor {
 public:
  explicit GhostsFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  struct Pose {
    double filmTime_s;
    Eigen::Matrix3d R_WB;
    /// From the body, as the camera stands at the film's start; of one that moves along, from the origin of space.
    Eigen::Vector3d place_V;
  };
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  const BodyFigure& body_;
  /// From the body as it is now.
  Eigen::Vector3d place_V(const Pose& pose, const PictureState& state) const;

  double scale_, strength_;
  bool moves_;  // along: each pose is where it was
  double flightScale_;
  std::vector<Pose> poses_;
};

}  // namespace poinsot::stage
