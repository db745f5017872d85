// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "draw/draw_list.h"
#include "scene/scene.h"
#include "stage/body/figure.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// Drawing of the body, with its fixed point at the origin, in m. The drawing consists of the parts to show, or
/// else of the parts that set the inertia. Without parts, a body with a mass is the uniform box at its centre of
/// mass, to scale; a body without a mass is the uniform box, or under gravity the uniform cone on its apex, of any
/// size.
class BodyFigure {
 public:
  explicit BodyFigure(const scene::Scene& scene);

  /// Returns the body's reach from the fixed point along each principal axis, m; negative if the body lies behind.
  const Eigen::Vector3d& reachAlongAxes() const { return reachAlongAxes_; }
  /// Returns half the body's extent along each principal axis, m.
  const Eigen::Vector3d& halfExtents() const { return halfExtents_; }
  double radius() const;
  /// Returns the factor by which an ellipsoid with these semi-axes along the principal axes must grow to hold the
  /// body.
  double reachIn(const Eigen::Vector3d& semiAxes_P) const;
  Eigen::Vector3d supportPoint(const Eigen::Vector3d& direction_B) const;

  /// Returns the body's farthest points in 26 directions, in V.
  std::vector<Eigen::Vector3d> outermostPoints(const Placement& place) const;

  /// Returns how far out a point (m) lies: 1 on the body's surface, less inside, infinite if the body is too thin
  /// to hide anything.
  double gauge(const Eigen::Vector3d& p_B) const;

  void add(draw::DrawList& list, const Placement& place, const Palette& colors, double lineWidth_px) const {
    addFigure(list, figure_, place, colors, lineWidth_px);
  }

 private:
  Figure figure_;
  Eigen::Matrix3d R_PB_;
  Eigen::Vector3d reachAlongAxes_, halfExtents_;
};

/// Returns half the edges of the uniform box that has moments in these proportions, in arbitrary units. The
/// smallest edge of a lamina is enlarged to stay visible.
Eigen::Vector3d equivalentBox(const physics::PrincipalMoments& moments);

/// Returns the uniform elliptic cone that has moments in these proportions about its apex, in arbitrary units: the
/// height along principal axis `axis` (0 to 2), and the semi-axes of the base along the others. Flat cones are
/// made thick enough to be visible.
Eigen::Vector3d equivalentCone(const physics::PrincipalMoments& moments, int axis);

}  // namespace poinsot::stage
