// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/axes_figure.h"

#include <array>
#include <string>

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSpaceAxisRadius = 0.008, kComponentRadius = 0.017;
constexpr double kBeyond = 1.15;  // length of a space axis, as a multiple of Scales::reach
// Shortest component that gets a label. A shorter component has no room for the head of its arrow, and edges of
// the box would coincide.
constexpr double kLeastNamed = 0.06;

}  // namespace

SpaceAxesFigure::SpaceAxesFigure(const Setting& setting)
    : length_(kBeyond * setting.scene.show.figures.spaceAxes.scale * setting.scales.reach) {}

void SpaceAxesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  constexpr std::array kNames{scene::LabelName::kX, scene::LabelName::kY, scene::LabelName::kZ};
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d tip = length_ * state.R_VW.col(axis);
    canvas.arrow(tip, kSpaceAxisRadius, canvas.colors.rod);
    canvas.point(std::string(1, "xyz"[axis]), tip);
    canvas.label(kNames[static_cast<std::size_t>(axis)], tip, Vector3d::Zero(), canvas.colors.quietInk, 0.8);
  }
}

std::vector<Vector3d> SpaceAxesFigure::outermostPoints(const PictureState& state) const {
  const Matrix3d tips = length_ * state.R_VW;
  return {tips.col(0), tips.col(1), tips.col(2)};
}

ComponentsFigure::ComponentsFigure(const Setting& setting)
    : scale_(setting.scales.omega * setting.scene.show.figures.components.scale) {}

Matrix3d ComponentsFigure::components_V(const PictureState& state) const {
  return scale_ * state.R_VP * state.omega_P.asDiagonal();
}

void ComponentsFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  constexpr std::array kNames{scene::LabelName::kOmega1, scene::LabelName::kOmega2, scene::LabelName::kOmega3};
  const Matrix3d parts = components_V(state);
  const draw::Color& color = canvas.colors.omegaParts;
  for (int i = 0; i < 3; ++i) {
    const Vector3d part = parts.col(i), second = parts.col((i + 1) % 3), third = parts.col((i + 2) % 3);
    canvas.arrow(part, kComponentRadius, color);
    canvas.point("omega" + std::to_string(i + 1), part);
    for (const Vector3d& from : {second, third, Vector3d(second + third)})
      canvas.line({from, from + part}, false, color, 0.7);
    if (part.norm() > kLeastNamed)
      canvas.label(kNames[static_cast<std::size_t>(i)], 0.75 * part, 0.75 * part + second + third, color, 0.85);
  }
}

std::vector<Vector3d> ComponentsFigure::outermostPoints(const PictureState& state) const {
  const Matrix3d parts = components_V(state);
  std::vector<Vector3d> corners{parts.rowwise().sum()};
  for (int i = 0; i < 3; ++i) {
    corners.push_back(parts.col(i));
    corners.push_back(parts.col(i) + parts.col((i + 1) % 3));
  }
  return corners;
}

}  // namespace poinsot::stage
