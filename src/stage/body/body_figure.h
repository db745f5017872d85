// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "draw/draw_list.h"
#include "scene/scene.h"
#include "stage/body/figure.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// The body as it is drawn, its fixed point at the origin: the parts to show, else the parts that set the inertia,
/// else what has the moments given: of a body with a mass the uniform box, at its centre of mass and to scale;
/// else the uniform box, or under gravity the uniform cone on its apex, of any size.
class BodyFigure {
 public:
  explicit BodyFigure(const scene::Scene& scene);

  /// How far it reaches from the fixed point in the direction of each principal axis, in m; negative where it lies
  /// behind.
  const Eigen::Vector3d& reachAlongAxes() const { return reachAlongAxes_; }
  /// Half its extent along each principal axis, in m.
  const Eigen::Vector3d& halfExtents() const { return halfExtents_; }
  /// Distance of the farthest point from the fixed point, in m.
  double radius() const;
  /// The factor by which an ellipsoid with these semi-axes along the principal axes must grow to hold the body.
  double reachIn(const Eigen::Vector3d& semiAxes_P) const;
  /// The farthest point in a direction of B, in m.
  Eigen::Vector3d supportPoint(const Eigen::Vector3d& direction_B) const;

  /// The farthest points in 26 directions, in the picture.
  std::vector<Eigen::Vector3d> outermostPoints(const Placement& place) const;

  /// How far out a point in metres lies: 1 on the body's surface, less inside, infinite where it hides nothing.
  double gauge(const Eigen::Vector3d& p_B) const;

  /// Adds the body; its place's scale is picture lengths per metre.
  void add(draw::DrawList& list, const Placement& place, const Palette& colors, double lineWidth_px) const {
    addFigure(list, figure_, place, colors, lineWidth_px);
  }

 private:
  Figure figure_;
  Eigen::Matrix3d R_PB_;
  Eigen::Vector3d reachAlongAxes_, halfExtents_;
};

/// Half the edges of the uniform box, of any mass, that has moments in these proportions; the smallest edge is
/// kept visible where the body is a lamina. In arbitrary units: only the proportions count.
Eigen::Vector3d equivalentBox(const physics::PrincipalMoments& moments);

/// The uniform elliptic cone about principal axis `axis` (0 to 2), of any mass, that has moments in these
/// proportions about its apex: its height along that axis, the semi-axes of its base along the others. In
/// arbitrary units; flat cones are kept visible.
Eigen::Vector3d equivalentCone(const physics::PrincipalMoments& moments, int axis);

}  // namespace poinsot::stage
