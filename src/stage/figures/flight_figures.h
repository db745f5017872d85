// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the flight of a thrown body (eq 1). Draws the path of the centre of mass, the arrow R from the origin
/// of space to the centre of mass, the velocity V and the weight. If the scene throws the body by a point K (eq
/// 4), R and V are those of K.
class FlightFigure final : public Actor {
 public:
  /// @pre the body moves through the view: setting.motion.flight().
  explicit FlightFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  Eigen::Vector3d origin_V(const PictureState& state) const { return -scale_ * state.centre_V; }
  /// Returns the path between two played times, in V.
  std::vector<Eigen::Vector3d> path_V(const PictureState& state, double from_s, double to_s) const;
  /// Returns the point whose R and V are drawn: the centre of mass, or K.
  Eigen::Vector3d point_V(const PictureState& state) const { return bodyScale_ * (state.R_VB * point_B_); }
  /// Return the tips of the arrows V, which begins at this point, and M g, which begins at the centre of mass.
  Eigen::Vector3d velocityTip_V(const PictureState& state) const {
    return point_V(state) + velocityScale_ * state.velocityAt(point_B_);
  }
  Eigen::Vector3d weightTip_V(const PictureState& state) const { return state.R_VW * weight_W_; }

 private:
  const PictureMotion& motion_;
  double scale_, bodyScale_, velocityScale_;
  Eigen::Vector3d point_B_, weight_W_;
  bool byPoint_, position_, velocity_, weight_;
  bool follows_;  // true if the camera follows the body; the origin of space may be outside the picture
};

/// Actor for the angular momentum of a thrown body about the origin of space. The angular momentum is the sum of R
/// x P and L (eq 5), so the arrow L is drawn at the tip of R x P. Also draws the torque of the weight about the
/// origin, which changes this angular momentum (eq 8).
class TotalAngularMomentumFigure final : public Actor {
 public:
  /// @pre the body moves through the view and has a mass.
  explicit TotalAngularMomentumFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  Eigen::Vector3d growsFrom(const PictureState& state) const override { return origin_V(state); }

  Eigen::Vector3d origin_V(const PictureState& state) const { return -placeScale_ * state.centre_V; }
  /// Return vectors that start at the origin of space: R x P, the sum of R x P and L, and the torque of the
  /// weight.
  Eigen::Vector3d orbital_V(const PictureState& state) const;
  Eigen::Vector3d total_V(const PictureState& state) const { return orbital_V(state) + scale_ * state.L_V; }
  Eigen::Vector3d torque_V(const PictureState& state) const;

 private:
  double placeScale_, scale_, torqueScale_, mass_kg_;
  Eigen::Vector3d weight_W_;
  bool torque_;
};

}  // namespace poinsot::stage
