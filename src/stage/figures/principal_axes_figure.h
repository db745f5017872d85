// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Of the arrows of body axes, in picture lengths.
inline constexpr double kAxisRadius = 0.0125;

/// The principal axes, arrows with their names. A name behind the body is not shown.
class PrincipalAxesFigure final : public Actor {
 public:
  explicit PrincipalAxesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  double ballRadius() const override;

 private:
  /// How much of a point is seen past the body: 0 behind it or inside, 1 clear of it, smooth between.
  float seenPast(const PictureState& state, const Eigen::Vector3d& point_V, const draw::Camera& camera) const;

  Eigen::Vector3d lengths_;
  const BodyFigure* body_;  // null where it is not shown
  double bodyScale_;
  bool insideEllipsoid_, inBall_;
};

/// How long the principal axes are drawn, from the fixed point to inside the ellipsoid or beyond the body.
Eigen::Vector3d principalAxisLengths(const scene::Scene& scene, const BodyFigure& body, const Scales& scales,
                                     const Construction* construction);

}  // namespace poinsot::stage
