// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the two cones that omega draws if all moments of a free body differ. The body cone passes through the
/// polhode and is fixed in the body. The space cone passes through the herpolhode and is fixed in space. The body
/// cone rolls on the space cone, and they touch along omega. The space cone need not close. It is drawn for half a
/// turn about L before and after the present, and its rim for the complete film. Lines along the sides draw the
/// cones.
class PolhodeConesFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is free, not steady, and not on the separatrix.
  explicit PolhodeConesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the rim of the body cone, a closed curve in picture lengths.
  std::vector<Eigen::Vector3d> bodyRim_V(const PictureState& state) const;
  /// Returns the rim of the space cone, from half a turn before the present to half a turn after it.
  std::vector<Eigen::Vector3d> spaceRim_V(double filmTime_s, const PictureState& state) const;

 private:
  void addPath(const Canvas& canvas, const PictureState& state, double from_s, double to_s) const;

  const PictureMotion& motion_;
  double side_;  // picture lengths per rad/s
  double opacity_;
  std::vector<Eigen::Vector3d> polhode_P_;
  double turn_s_;                // mean time of a turn about L, in time of the motion
  double height_, outerRadius_;  // of the rim of the space cone, in picture lengths
};

}  // namespace poinsot::stage
