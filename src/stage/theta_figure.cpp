// SPDX-License-Identifier: Apache-2.0
#include "stage/theta_figure.h"

#include <algorithm>
#include <cmath>

#include "stage/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kAxisRadius = 0.0125;  // as of the principal axes
constexpr double kArcShare = 0.72;      // of the shorter of the two arrows
constexpr double kVertical = 1.5;       // length of the vertical, as of L where it is longest
constexpr int kArcPoints = 48;

double longestL(const Setting& setting) {
  double longest = 0;
  for (const PathPoint& p : setting.motion.outline()) longest = std::max(longest, setting.scales.L * p.L_W.norm());
  return longest;
}

double lengthOfAxis(const Setting& setting) {
  return setting.axisLengths.dot(mainAxis_P(setting.motion).cwiseAbs());
}

}  // namespace

MainAxisFigure::MainAxisFigure(const Setting& setting)
    : tip_P_(setting.scene.show.figures.mainAxis.scale * lengthOfAxis(setting) * mainAxis_P(setting.motion)) {}

void MainAxisFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Vector3d tip = state.R_VP * tip_P_;
  canvas.arrow(tip, kAxisRadius, canvas.colors.axis);
  canvas.label("$\\hat{\\mathbf{k}}$", tip, Vector3d::Zero(), canvas.colors.axis);
}

std::vector<Vector3d> MainAxisFigure::outermostPoints(const PictureState& state) const {
  return {state.R_VP * tip_P_};
}

ThetaFigure::ThetaFigure(const Setting& setting)
    : k_P_(mainAxis_P(setting.motion)),
      fromVertical_(!setting.scene.motion.forcing.gravity_B.isZero(0)),
      radius_(kArcShare * setting.scene.show.figures.theta.scale *
              std::min(fromVertical_ ? kVertical : longestL(setting), lengthOfAxis(setting))) {}

Vector3d ThetaFigure::from_V(const PictureState& state) const {
  return fromVertical_ ? Vector3d(state.R_VW.col(2)) : Vector3d(state.L_V.normalized());
}

// sin((1 - s) theta) a + sin(s theta) b over sin(theta): exact at both ends and without an axis to turn about.
std::vector<Vector3d> ThetaFigure::arc(const PictureState& state) const {
  const Vector3d a = from_V(state), b = state.R_VP * k_P_;
  const double theta = std::atan2(a.cross(b).norm(), a.dot(b));
  if (a.isZero(0) || !(std::sin(theta) > 1e-9)) return {};
  std::vector<Vector3d> points;
  for (int i = 0; i <= kArcPoints; ++i) {
    const double s = static_cast<double>(i) / kArcPoints;
    points.push_back(radius_ / std::sin(theta) * (std::sin((1 - s) * theta) * a + std::sin(s * theta) * b));
  }
  return points;
}

void ThetaFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (fromVertical_) canvas.dashes(Vector3d::Zero(), kVertical * from_V(state), canvas.colors.quietInk, 1.1);
  const std::vector<Vector3d> points = arc(state);
  if (points.empty()) return;
  canvas.line(points, false, canvas.colors.ink, 1.6);
  canvas.label("$\\theta$", points[points.size() / 2], Vector3d::Zero(), canvas.colors.ink);
}

std::vector<Vector3d> ThetaFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points = arc(state);
  if (fromVertical_) points.push_back(kVertical * from_V(state));
  return points;
}

}  // namespace poinsot::stage
