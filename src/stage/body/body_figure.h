// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "draw/draw_list.h"
#include "scene/scene.h"
#include "stage/body/figure.h"
#include "stage/palette.h"

namespace poinsot::stage {

/// Drawing of the body, with its fixed point at the origin, in m. The drawing shows the parts that the scene
/// lists. A body without parts is drawn as a solid with the same ratios of principal moments:
/// - if the mass is known, a uniform box at the centre of mass, to scale;
/// - otherwise, under gravity, a uniform cone on its apex, of any size;
/// - otherwise, a uniform box of any size.
class BodyFigure {
 public:
  explicit BodyFigure(const scene::Scene& scene);

  /// Returns how far the body reaches from the fixed point along each principal axis, m. The value is negative if
  /// the complete body lies on the negative side.
  const Eigen::Vector3d& reachAlongAxes() const { return reachAlongAxes_; }
  /// Returns half the body's extent along each principal axis, m.
  const Eigen::Vector3d& halfExtents() const { return halfExtents_; }
  double radius() const;
  /// Returns the factor by which an ellipsoid must grow to contain the body.
  /// @param semiAxes_P  semi-axes of the ellipsoid along the principal axes
  double reachIn(const Eigen::Vector3d& semiAxes_P) const;
  Eigen::Vector3d supportPoint(const Eigen::Vector3d& direction_B) const;

  /// Returns the farthest point of the body in each of 26 directions, in V.
  std::vector<Eigen::Vector3d> outermostPoints(const Placement& place) const;

  /// Returns the position of a point relative to the body's surface: less than 1 inside, 1 on the surface, more
  /// than 1 outside. Returns infinity if the body is too thin to hide anything.
  /// @param p_B  point, m
  double gauge(const Eigen::Vector3d& p_B) const;

  void add(draw::DrawList& list, const Placement& place, const Palette& colors, double lineWidth_px) const {
    addFigure(list, figure_, place, colors, lineWidth_px);
    for (const MarkFigure& mark : marks_) addFigure(list, mark.figure, place, mark.painted(colors), lineWidth_px);
  }

 private:
  /// Figure of a mark on the body, in its own colour.
  struct MarkFigure {
    Figure figure;
    physics::MarkTone tone;
    std::optional<std::uint32_t> color;

    /// Returns the palette with the mark's colour as the colour of the body.
    Palette painted(const Palette& colors) const;
  };

  Figure figure_;
  std::vector<MarkFigure> marks_;
  Eigen::Matrix3d R_PB_;
  Eigen::Vector3d reachAlongAxes_, halfExtents_;
};

/// Returns half the edges of a uniform box whose moments have the ratios of `moments`, in arbitrary units. The
/// smallest edge of a lamina is enlarged, so that it stays visible.
Eigen::Vector3d equivalentBox(const physics::PrincipalMoments& moments);

/// Returns the size of a uniform elliptic cone whose moments about its apex have the ratios of `moments`, in
/// arbitrary units. The component `axis` (0 to 2) is the height of the cone, and the others are the semi-axes of
/// its base. Flat cones are made thick enough to be visible.
Eigen::Vector3d equivalentCone(const physics::PrincipalMoments& moments, int axis);

}  // namespace poinsot::stage
