// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "draw/draw_list.h"
#include "scene/scene.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// The body as it is drawn: the shape to show, else the shape that set the inertia, else the uniform box that has
/// the moments given.
class BodyFigure {
 public:
  explicit BodyFigure(const scene::Scene& scene);

  /// Half the extents along the body's axes, in m, about the centre of mass.
  const Eigen::Vector3d& halfExtents() const { return halfExtents_; }
  /// Distance of the farthest point from the centre of mass, in m.
  double radius() const;
  /// The factor by which an ellipsoid with these semi-axes must grow to hold the body.
  double reachIn(const Eigen::Vector3d& semiAxes) const;

  /// How far out a point in metres lies: 1 on the body's surface, less inside, infinite where it hides nothing.
  double gauge(const Eigen::Vector3d& p_B) const;

  /// Adds the body at the origin of V; `scale` is picture lengths per metre.
  void add(draw::DrawList& list, const Eigen::Matrix3d& R_VB, double scale, const Palette& colors,
           double lineWidth_px) const;

 private:
  std::vector<Eigen::Vector3d> outermostPoints() const;

  scene::Shape shape_;
  Eigen::Vector3d halfExtents_;
};

/// Half the edges of the uniform box, of any mass, that has moments in these proportions; the smallest edge is
/// kept visible where the body is a lamina. In arbitrary units: only the proportions count.
Eigen::Vector3d equivalentBox(const physics::PrincipalMoments& moments);

}  // namespace poinsot::stage
