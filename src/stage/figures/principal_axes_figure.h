// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Radius of the arrows of body axes, in picture lengths.
inline constexpr double kAxisRadius = 0.0125;

/// Actor for the principal axes, drawn as arrows with their names. A name behind the body is hidden.
class PrincipalAxesFigure final : public Actor {
 public:
  explicit PrincipalAxesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  double ballRadius() const override;

 private:
  /// Returns the visibility of a point: 0 if the point is inside or behind the body, 1 if it is clear of the body,
  /// with a smooth transition.
  float seenPast(const PictureState& state, const Eigen::Vector3d& point_V, const draw::Camera& camera) const;

  Eigen::Vector3d lengths_;
  std::vector<int> axes_;   // indices of the axes that are drawn
  const BodyFigure* body_;  // null if the body is not shown
  double bodyScale_;
  bool insideEllipsoid_, inBall_;
};

/// Returns the drawn lengths of the principal axes. If the ellipsoid is shown, the axes end inside it. Otherwise
/// they end beyond the body.
Eigen::Vector3d principalAxisLengths(const scene::Scene& scene, const BodyFigure& body, const Scales& scales,
                                     const Construction* construction);

}  // namespace poinsot::stage
