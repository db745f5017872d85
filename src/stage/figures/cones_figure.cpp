// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/cones_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stage/figures/symmetric_top.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr int kFramedPoints = 24;
constexpr double kNarrowest = 1e-3;  // smallest radius and height of a drawn cone, as fractions of its side
constexpr double kSpacing = 0.2;     // approximate distance of the lines along the rim, as a fraction of the side

}  // namespace

ConesFigure::ConesFigure(const Setting& setting)
    : cones_(precessionOf(setting.motion, "show.cones.visible")),
      side_(ConeLook::kSide * setting.scene.show.figures.cones.scale * setting.scales.omega *
            setting.motion.liveliest().omega_P.norm()),
      opacity_(setting.scene.show.figures.cones.opacity) {}

ConesFigure::Cone ConesFigure::bodyCone(const PictureState& state) const {
  return {state.R_VP * cones_.k_P, cones_.bodyCone_rad};
}

ConesFigure::Cone ConesFigure::spaceCone(const PictureState& state) const {
  return {state.L_V.normalized(), cones_.spaceCone_rad};
}

std::vector<Vector3d> ConesFigure::rim(const Cone& cone) const {
  return circleAbout(side_ * std::cos(cone.halfAngle_rad) * cone.axis_V, cone.axis_V,
                     side_ * std::sin(cone.halfAngle_rad), kFramedPoints);
}

// Draws a glass cone with a strong rim, and lines along its side. The lines are fixed in the same axes as the
// cone, so they make the rolling visible.
void ConesFigure::addCone(const Canvas& canvas, const Cone& cone, const Vector3d& hint_V,
                          const draw::Color& color) const {
  const double height = side_ * std::cos(cone.halfAngle_rad), radius = side_ * std::sin(cone.halfAngle_rad);
  if (!(radius > kNarrowest * side_) || !(height > kNarrowest * side_)) return;
  canvas.list.glassCones.push_back(glass(canvas, cone, color));
  const Vector3d u = across(cone.axis_V, hint_V), v = cone.axis_V.cross(u);
  const int lines = std::max(4, static_cast<int>(std::round(2 * std::numbers::pi * radius / (side_ * kSpacing))));
  for (int i = 0; i < lines; ++i) {
    const double angle = 2 * std::numbers::pi * i / lines;
    const Vector3d onRim = height * cone.axis_V + radius * (std::cos(angle) * u + std::sin(angle) * v);
    canvas.line({ConeLook::kInside * onRim, onRim}, false, mixed(color, canvas.colors.paper, ConeLook::kLineShare),
                0.9);
  }
}

draw::GlassCone ConesFigure::glass(const Canvas& canvas, const Cone& cone, const draw::Color& color) const {
  draw::GlassCone glass;
  glass.axis_V = toPicture(cone.axis_V);
  glass.halfAngle_rad = static_cast<float>(cone.halfAngle_rad);
  glass.height_V = static_cast<float>(side_ * std::cos(cone.halfAngle_rad));
  glass.color = color;
  glass.nearOpacity = canvas.glass(opacity_);
  glass.farOpacity = canvas.glass(opacity_);
  glass.rimOpacity = canvas.glass(opacity_, 2);
  glass.lineColor = color;
  glass.lineWidth_px = static_cast<float>(ConeLook::kRimWidth * canvas.line_px);
  return glass;
}

// Writes the name beside the point of the rim that is farthest from the other cone.
void ConesFigure::addName(const Canvas& canvas, const Cone& cone, const Cone& other, scene::LabelName name,
                          const draw::Color& color) const {
  const Vector3d away_V = cone.axis_V - cone.axis_V.dot(other.axis_V) * other.axis_V;
  const Vector3d middle_V = side_ * std::cos(cone.halfAngle_rad) * cone.axis_V;
  const Vector3d onRim_V = middle_V + side_ * std::sin(cone.halfAngle_rad) * across(cone.axis_V, away_V);
  canvas.label(name, onRim_V, middle_V, color, ConeLook::kNameSize);
}

void ConesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Cone space = spaceCone(state), body = bodyCone(state);
  addCone(canvas, space, state.R_VW.col(0), canvas.colors.spaceCone);
  addCone(canvas, body, state.R_VP.col((cones_.axis + 1) % 3), canvas.colors.bodyCone);
  addName(canvas, space, body, scene::LabelName::kSpaceCone, canvas.colors.spaceCone);
  addName(canvas, body, space, scene::LabelName::kBodyCone, canvas.colors.bodyCone);
}

std::vector<Vector3d> ConesFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points = rim(bodyCone(state));
  for (const Vector3d& p : rim(spaceCone(state))) points.push_back(p);
  return points;
}

}  // namespace poinsot::stage
