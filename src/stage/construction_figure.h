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
/// contact at the tip of omega, the polhode on the one and the herpolhode on the other. Where something acts on
/// the body, ellipsoid and plane are those of the instant; the paths of omega stay as they were. An instant of
/// rest has neither.
class ConstructionFigure {
 public:
  ConstructionFigure(const scene::Scene& scene, const PictureMotion& motion, const Scales& scales);

  void add(draw::DrawList& list, double filmTime_s, const PictureState& state, const Palette& colors,
           double lineWidth_px) const;

  /// Points that the frame must hold, in V.
  std::vector<Eigen::Vector3d> outermostPoints() const;
  /// Corners of the plane's square, in order. @pre not at rest.
  std::array<Eigen::Vector3d, 4> planeCorners(const PictureState& state) const;
  /// Spacing of the plane's grid in rad/s: 1, 2 or 5 times a power of ten.
  double gridSpacing() const { return spacing_; }
  /// Distance of the plane from the centre, in the picture. @pre not at rest.
  double planeHeight(const PictureState& state) const;
  /// Semi-axes of the ellipsoid in the picture, in the order of the principal axes, where they are longest.
  const Eigen::Vector3d& semiAxes() const { return semiAxes_; }

 private:
  void addEllipsoid(draw::DrawList& list, const PictureState& state, const Palette& colors, double width_px) const;
  void addPlane(draw::DrawList& list, const PictureState& state, const Palette& colors, double width_px) const;
  void addPolhode(draw::DrawList& list, double filmTime_s, const PictureState& state, const Palette& colors) const;
  physics::PoinsotConstruction constructionAt(const PictureState& state) const;
  Eigen::Matrix<double, 3, 2> planeAxes_W(const Eigen::Vector3d& normal_W) const;
  draw::Curve curveOn(const Eigen::Matrix3d& axes_V, const std::vector<Eigen::Vector3d>& points) const;
  void addHerpolhode(draw::DrawList& list, double filmTime_s, const Palette& colors, double width_px) const;

  const scene::Show show_;
  const PictureMotion& motion_;
  double scale_;
  Eigen::Vector3d semiAxes_;                // in the picture
  std::vector<Eigen::Vector3d> polhode_P_;  // of free motion: the closed curve, rad/s
  double polhodePeriod_s_;                  // of film time; infinite where the curve does not close
  Eigen::Vector3d gridHint_W_;              // about where one family of the grid's lines runs
  double spacing_ = 1;
  double halfWidth_ = 1;
};

}  // namespace poinsot::stage
