// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/triad_figure.h"

#include <array>
#include <string>

#include "stage/figures/principal_axes_figure.h"
#include "stage/figures/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTriadReach = 1.15;  // length of the axes, as a multiple of Scales::reach
constexpr double kSideRadius = 0.02;  // thicker than the axes, which the components cover
constexpr double kLeastSide = 0.06;   // a shorter component has no room for its label

}  // namespace

double triadLength(const Setting& setting) {
  return kTriadReach * setting.scales.reach * setting.scene.show.figures.triad.scale;
}

TriadFigure::TriadFigure(const Setting& setting)
    : cones_(triadOf(setting.motion, "show.triad.visible")),
      length_(triadLength(setting)),
      omegaScale_(setting.scales.omega),
      components_(setting.scene.show.figures.triad.components),
      namesK_(!setting.scene.show.figures.mainAxis.visible) {}

Matrix3d TriadFigure::axes_V(const PictureState& state) const { return length_ * triad_V(state, cones_); }

TriadFigure::Components TriadFigure::components_V(const PictureState& state) const {
  const Matrix3d axes = triad_V(state, cones_);
  const Vector3d omega = omegaScale_ * state.omega_V;
  return {omega.dot(axes.col(0)) * axes.col(0), omega.dot(axes.col(2)) * axes.col(2)};
}

void TriadFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  constexpr std::array kNames{scene::LabelName::kI, scene::LabelName::kJ, scene::LabelName::kAxis};
  const Matrix3d axes = axes_V(state);
  for (int i = 0; i < 3; ++i) {
    const Vector3d tip = axes.col(i);
    canvas.arrow(tip, kAxisRadius, canvas.colors.axis);
    canvas.point(std::string(1, "ijk"[i]), tip);
    if (i < 2 || namesK_)
      canvas.label(kNames[static_cast<std::size_t>(i)], tip, Vector3d::Zero(), canvas.colors.axis);
  }
  if (components_) addComponents(canvas, state);
}

void TriadFigure::addComponents(const Canvas& canvas, const PictureState& state) const {
  const auto [alongI, alongK] = components_V(state);
  const draw::Color& color = canvas.colors.omegaParts;
  const auto side = [&](const Vector3d& part, const Vector3d& other, const char* point, scene::LabelName name) {
    canvas.arrow(part, kSideRadius, color);
    canvas.point(point, part);
    canvas.dashes(other, part + other, color, 1.2);
    if (part.norm() > kLeastSide) canvas.label(name, 0.7 * part, 0.7 * part + other, color, 0.85);
  };
  side(alongI, alongK, "omega1", scene::LabelName::kOmega1);
  side(alongK, alongI, "omega3", scene::LabelName::kOmega3);
}

std::vector<Vector3d> TriadFigure::outermostPoints(const PictureState& state) const {
  const Matrix3d axes = axes_V(state);
  std::vector<Vector3d> points{axes.col(0), axes.col(1), axes.col(2)};
  if (!components_) return points;
  const auto [alongI, alongK] = components_V(state);
  points.insert(points.end(), {alongI, alongK, alongI + alongK});
  return points;
}

}  // namespace poinsot::stage
