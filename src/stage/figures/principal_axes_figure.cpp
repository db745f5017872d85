// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/principal_axes_figure.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <string>

#include "stage/figures/stand_figure.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// Lengths of axes: kInEllipsoid times the semi-axes of the ellipsoid. Without an ellipsoid: kBeyondBody times the
// reach of the body, plus kClear picture lengths.
constexpr double kInEllipsoid = 0.88, kBeyondBody = 1.3, kClear = 0.12;
// Smallest reach from which the length of an axis is computed, as a fraction of half the body's longest extent.
// Used for an axis that points away from the body.
constexpr double kLeast = 0.3;
// Fraction of an axis that must be inside the picture. The full length is not needed, because labels stay inside
// the picture by themselves and few axes point outwards.
constexpr double kFramed = 0.8;
constexpr double kAxisNameSize = 0.85;
constexpr std::array kAxisNames{scene::LabelName::kE1, scene::LabelName::kE2, scene::LabelName::kE3};

}  // namespace

Vector3d principalAxisLengths(const scene::Scene& scene, const BodyFigure& body, const Scales& scales,
                              const Construction* construction) {
  const double factor = scene.show.principalAxes.scale;
  if (construction && scene.show.ellipsoid.visible) return factor * kInEllipsoid * construction->semiAxes();
  const double least_m = kLeast * body.halfExtents().maxCoeff();
  const Vector3d reach_m = body.reachAlongAxes().cwiseMax(least_m);
  return factor * (kBeyondBody * scales.body * reach_m + Vector3d::Constant(kClear));
}

PrincipalAxesFigure::PrincipalAxesFigure(const Setting& setting)
    : lengths_(setting.axisLengths),
      axes_(setting.scene.show.principalAxes.axes),
      body_(setting.scene.show.body.visible ? &setting.body : nullptr),
      bodyScale_(setting.scales.body),
      insideEllipsoid_(setting.construction && setting.scene.show.ellipsoid.visible &&
                       setting.scene.show.principalAxes.scale <= 1),
      inBall_(!standsOnPivot(setting.scene) && !setting.motion.flight()) {}

void PrincipalAxesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const glm::vec2 centre = canvas.at_px(Vector3d::Zero());
  for (const int axis : axes_) {
    const Vector3d tip_V = lengths_[axis] * state.R_VP.col(axis);
    canvas.arrow(tip_V, kAxisRadius, canvas.colors.axis);
    canvas.point("e" + std::to_string(axis + 1), tip_V);
    const scene::LabelName name = kAxisNames[static_cast<std::size_t>(axis)];
    if (canvas.type_px == 0 || canvas.names[name].empty()) continue;
    // An axis that points at the eye has no direction in the picture, so its label leans upwards.
    const auto lean = static_cast<float>(1.2 * canvas.type_px);
    const glm::vec2 away = canvas.at_px(tip_V) - centre + glm::vec2(0, -lean);
    const float seen = body_ ? seenPast(state, tip_V, canvas.list.camera) : 1;
    canvas.labelAt(name, canvas.at_px(tip_V), softUnit(away, 0.6f * lean), canvas.colors.axis, kAxisNameSize,
                   kLabelGap, seen);
  }
}

float PrincipalAxesFigure::seenPast(const PictureState& state, const Vector3d& point_V,
                                    const draw::Camera& camera) const {
  constexpr int kSteps = 32;
  const Vector3d sight =
      camera.orthographic ? fromPicture(camera.R_VC[2]) : Vector3d(fromPicture(camera.eye_V) - point_V);
  const Vector3d towardEye = sight.normalized() * 2 * bodyScale_ * body_->radius();
  double nearest = 2;
  for (int i = 0; i <= kSteps; ++i)
    nearest =
        std::min(nearest, body_->gauge(state.R_VB.transpose() * (point_V + towardEye * i / kSteps) / bodyScale_));
  return static_cast<float>(glm::smoothstep(0.95, 1.25, nearest));
}

// Follows the same rules as BodyActor::outermostPoints().
std::vector<Vector3d> PrincipalAxesFigure::outermostPoints(const PictureState& state) const {
  if (insideEllipsoid_ || inBall_) return {};
  const Eigen::Matrix3d tips = state.R_VP * lengths_.asDiagonal();
  std::vector<Vector3d> points;
  for (const int axis : axes_) points.emplace_back(tips.col(axis));
  return points;
}

double PrincipalAxesFigure::ballRadius() const {
  return !insideEllipsoid_ && inBall_ ? kFramed * lengths_.maxCoeff() : 0;
}

}  // namespace poinsot::stage
