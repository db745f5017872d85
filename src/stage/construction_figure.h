// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "draw/draw_list.h"
#include "physics/poinsot_construction.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "stage/scales.h"

namespace poinsot::stage {

/// Poinsot's construction: the energy ellipsoid (eq 38) rolling on the invariable plane (eq 40), the point of
/// contact at the tip of omega, the polhode on the one and the herpolhode on the other.
class ConstructionFigure {
 public:
  ConstructionFigure(const scene::Scene& scene, const PictureMotion& motion, const Scales& scales);

  void add(draw::DrawList& list, double filmTime_s, const PictureState& state, const Palette& colors,
           double lineWidth_px) const;

  /// Points that the frame must hold, in V.
  std::vector<Eigen::Vector3d> outermostPoints() const;
  /// Corners of the plane's square, in order.
  std::array<Eigen::Vector3d, 4> planeCorners(const Eigen::Matrix3d& R_VW) const;
  /// Spacing of the plane's grid in rad/s: 1, 2 or 5 times a power of ten.
  double gridSpacing() const { return spacing_; }
  /// Distance of the plane from the centre, in the picture.
  double planeHeight() const { return height_; }
  /// Semi-axes of the ellipsoid in the picture, in the order of the body axes.
  const Eigen::Vector3d& semiAxes() const { return semiAxes_; }

 private:
  void addEllipsoid(draw::DrawList& list, const PictureState& state, const Palette& colors, double width_px) const;
  void addPlane(draw::DrawList& list, const PictureState& state, const Palette& colors, double width_px) const;
  void addPolhode(draw::DrawList& list, double filmTime_s, const PictureState& state, const Palette& colors) const;
  draw::Curve curveOn(const Eigen::Matrix3d& axes_V, const std::vector<Eigen::Vector3d>& points) const;
  void addHerpolhode(draw::DrawList& list, double filmTime_s, const Palette& colors, double width_px) const;

  const scene::Show show_;
  const PictureMotion& motion_;
  double scale_;
  Eigen::Vector3d semiAxes_;                // in the picture
  std::vector<Eigen::Vector3d> polhode_P_;  // the closed curve, rad/s
  double polhodePeriod_s_;                  // of film time; infinite on the separatrix
  double height_ = 0;
  double spacing_ = 1;
  double halfWidth_ = 1;
};

}  // namespace poinsot::stage
