// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/vector_figures.h"

#include <algorithm>

#include "stage/figures/arrow.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kVectorRadius = 0.019;
constexpr double kLongestTorque = 0.9;
constexpr double kAlongShaft = 0.62;  // position of omega's label along the shaft
constexpr double kFarRight = 0.9;     // distance right of L at which omega's label changes sides, in text sizes
constexpr double kNoName = 0.02;      // length of L, in picture lengths, below which it has no label
constexpr double kFading = 0.5;       // distance from kFarRight within which omega's label fades, in text sizes

float headRadius_px(const Canvas& canvas, const Vector3d& tip_V) {
  const draw::Camera& camera = canvas.list.camera;
  return static_cast<float>(headRadius(kVectorRadius)) * camera.scale_px(depthOf(camera, toPicture(tip_V)));
}

/// Returns the direction from an arrow's tip to its label. The label is to the right of an upright arrow, and
/// perpendicular to a slanting arrow. The label of a horizontal arrow is beyond the tip, where it changes sides.
glm::vec2 besideTip(glm::vec2 along) {
  const float upright = std::clamp(along.y / 0.3f, -1.0f, 1.0f);
  const glm::vec2 square(std::abs(along.y), -along.x * upright);
  return square + (1 - std::abs(upright)) * along;
}

}  // namespace

AngularMomentumFigure::AngularMomentumFigure(const Setting& setting) : scale_(setting.scales.L) {}

void AngularMomentumFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Vector3d tip_V = scale_ * state.L_V;
  if (tip_V.isZero(0)) return;
  canvas.arrow(tip_V, kVectorRadius, canvas.colors.L);
  canvas.point("L", tip_V);
  const glm::vec2 tip = canvas.at_px(tip_V), along = softUnit(tip - canvas.at_px(Vector3d::Zero()), 1);
  const double there = std::clamp((tip_V.norm() - kNoName) / kNoName, 0.0, 1.0);
  if (there > 0)
    canvas.labelAt(scene::LabelName::kL, tip, besideTip(along), canvas.colors.L, canvas.arrowName,
                   kLabelGap / canvas.arrowName, static_cast<float>(there));
}

std::vector<Vector3d> AngularMomentumFigure::outermostPoints(const PictureState& state) const {
  return {scale_ * state.L_V};
}

AngularVelocityFigure::AngularVelocityFigure(const Setting& setting)
    : scale_(setting.scales.omega),
      inConstruction_(setting.scene.show.plane.visible || setting.scene.show.ellipsoid.visible) {}

void AngularVelocityFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (state.atRest()) return;
  canvas.arrow(scale_ * state.omega_V, kVectorRadius, canvas.colors.omega);
  canvas.point("omega", scale_ * state.omega_V);
  addName(canvas, scale_ * state.omega_V);
}

// In the construction, the label is to the left of the shaft, or to the left of L if L is farther left. If the
// shaft is far to the right of L, the label is to the right of the shaft, because it could be mistaken for the
// label of L. The label fades while it changes sides.
// Without the construction, the label is above the tip and leans outwards. It therefore moves smoothly from side
// to side while the tip rotates.
void AngularVelocityFigure::addName(const Canvas& canvas, const Vector3d& tip_V) const {
  using enum scene::LabelName;
  const glm::vec2 centre = canvas.at_px(Vector3d::Zero());
  const double gap = kLabelGap / canvas.arrowName;
  if (inConstruction_) {
    const glm::vec2 beside = canvas.at_px(kAlongShaft * tip_V);
    const double off = (beside.x - centre.x) / canvas.type_px;
    const bool right = off > kFarRight;
    const glm::vec2 place(right ? beside.x : std::min(beside.x, centre.x), beside.y);
    const float head_px = headRadius_px(canvas, tip_V);
    const double there = canvas.still ? 1 : std::min(1.0, std::abs(off - kFarRight) / kFading);
    canvas.labelAt(kOmega, place + glm::vec2(right ? head_px : -head_px, 0), {right ? 1 : -1, 0},
                   canvas.colors.omega, canvas.arrowName, 0.5 * gap, static_cast<float>(there));
    return;
  }
  const glm::vec2 tip = canvas.at_px(tip_V);
  const double lean = std::clamp((tip.x - centre.x) / (2 * canvas.type_px), -1.0, 1.0);
  canvas.labelAt(kOmega, tip, {lean, -1.1}, canvas.colors.omega, canvas.arrowName, gap);
}

std::vector<Vector3d> AngularVelocityFigure::outermostPoints(const PictureState& state) const {
  return {scale_ * state.omega_V};
}

TorqueFigure::TorqueFigure(const Setting& setting) : scale_(0) {
  double longest = 0;
  for (const PathPoint& p : setting.motion.outline())
    longest = std::max(longest, setting.motion.atPlayed(p.played_s).torque_V.norm());
  if (longest > 0) scale_ = kLongestTorque * setting.scene.show.figures.torque.scale / longest;
}

void TorqueFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Vector3d tip_V = scale_ * state.torque_V;
  if (tip_V.isZero(0)) return;
  canvas.arrow(tip_V, kVectorRadius, canvas.colors.torque);
  canvas.point("torque", tip_V);
  canvas.label(scene::LabelName::kTorque, tip_V, Vector3d::Zero(), canvas.colors.torque, canvas.arrowName);
}

std::vector<Vector3d> TorqueFigure::outermostPoints(const PictureState& state) const {
  return {scale_ * state.torque_V};
}

}  // namespace poinsot::stage
