// SPDX-License-Identifier: Apache-2.0
#include "stage/cones_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stage/symmetric_top.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 0.76;  // of omega: its head stands out beyond the rims
constexpr int kRimPoints = 128, kFramedPoints = 24;
constexpr double kRimRadius = 0.009;
constexpr double kSpacing = 0.2;  // about, of the lines on a cone, along its rim, in sides
constexpr double kLineShare = 0.45;

}  // namespace

ConesFigure::ConesFigure(const Setting& setting)
    : cones_(precessionOf(setting.motion, "show.cones.visible")),
      side_(kSide * setting.scene.show.figures.cones.scale * setting.scales.omega *
            setting.motion.liveliest().omega_P.norm()),
      opacity_(setting.scene.show.figures.cones.opacity) {}

ConesFigure::Cone ConesFigure::bodyCone(const PictureState& state) const {
  return {state.R_VP * cones_.k_P, cones_.bodyCone_rad};
}

ConesFigure::Cone ConesFigure::spaceCone(const PictureState& state) const {
  return {state.L_V.normalized(), cones_.spaceCone_rad};
}

std::vector<Vector3d> ConesFigure::rim(const Cone& cone, int points) const {
  return circleAbout(side_ * std::cos(cone.halfAngle_rad) * cone.axis_V, cone.axis_V,
                     side_ * std::sin(cone.halfAngle_rad), points);
}

// The lines turn with what the cone is fixed to: they show the rolling.
void ConesFigure::addCone(const Canvas& canvas, const Cone& cone, const Vector3d& hint_V,
                          const draw::Color& color) const {
  const double height = side_ * std::cos(cone.halfAngle_rad), radius = side_ * std::sin(cone.halfAngle_rad);
  const Vector3d u = across(cone.axis_V, hint_V), v = cone.axis_V.cross(u);
  const int lines = std::max(4, static_cast<int>(std::round(2 * std::numbers::pi * radius / (side_ * kSpacing))));
  for (int i = 0; i < lines; ++i) {
    const double angle = 2 * std::numbers::pi * i / lines;
    const Vector3d onRim = height * cone.axis_V + radius * (std::cos(angle) * u + std::sin(angle) * v);
    canvas.line({Vector3d::Zero(), onRim}, false, mixed(color, canvas.colors.paper, kLineShare), 0.8);
  }
  draw::Curve firm;
  for (const Vector3d& p : rim(cone, kRimPoints)) firm.points_W.push_back(toPicture(p));
  firm.closed = true;
  firm.radius_W = static_cast<float>(kRimRadius * canvas.thickness);
  firm.material.color = color;
  canvas.list.curves.push_back(std::move(firm));
}

void ConesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  addCone(canvas, spaceCone(state), state.R_VW.col(0), canvas.colors.L);
  addCone(canvas, bodyCone(state), state.R_VP.col((cones_.axis + 1) % 3), canvas.colors.axis);
}

std::vector<Vector3d> ConesFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points = rim(bodyCone(state), kFramedPoints);
  for (const Vector3d& p : rim(spaceCone(state), kFramedPoints)) points.push_back(p);
  return points;
}

}  // namespace poinsot::stage
