// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/flight_figures.h"

#include <algorithm>

#include "core/expect.h"
#include "stage/even_times.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kFlightArrowRadius = 0.016;
constexpr double kCentreDot = 0.028;
constexpr double kWeight = 0.55;  // length of the arrow M g
constexpr double kLongestWeightTorque = 0.9;
constexpr double kPale = 0.4;           // strength of the path that is still to come
constexpr std::size_t kPathSteps = 96;  // number of steps; a parabola in a picture of 4000 px is 0.1 px off
constexpr double kNameOfL = 0.55;
constexpr double kNameOfR = 0.5;   // position of R's label along its arrow
constexpr double kNearBody = 0.8;  // largest distance of R's label from a body that the camera follows

Vector3d unitOrZero(const Vector3d& v) { return v.isZero(0) ? v : Vector3d(v.normalized()); }

}  // namespace

FlightFigure::FlightFigure(const Setting& setting)
    : motion_(setting.motion),
      scale_(setting.scales.flight),
      bodyScale_(setting.scales.body),
      velocityScale_(setting.scales.velocity),
      point_B_(scene::referencePoint_B(setting.scene)),
      byPoint_(setting.scene.motion.thrownBy_B),
      position_(setting.scene.show.figures.flight.position),
      velocity_(setting.scene.show.figures.flight.velocity),
      weight_(setting.scene.show.figures.flight.weight),
      follows_(setting.scene.camera.follow) {
  POINSOT_EXPECT(motion_.flight());
  weight_W_ = kWeight * unitOrZero(motion_.flight()->gravity_W);
}

std::vector<Vector3d> FlightFigure::path_V(const PictureState& state, double from_s, double to_s) const {
  const double step_s = motion_.length_s() / kPathSteps;
  std::vector<Vector3d> points;
  for (const double t_s : evenTimes(from_s, to_s, step_s, 2 * kPathSteps + 3))
    points.emplace_back(scale_ * (motion_.atPlayed(t_s).centre_V - state.centre_V));
  return points;
}

void FlightFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  const draw::Color& color = canvas.colors.vector;
  const Trail trail = motion_.trail(filmTime_s, motion_.length_s());
  if (trail.end > trail.now)
    canvas.line(path_V(state, trail.now, trail.end), false, mixed(color, canvas.colors.paper, kPale), 1.4);
  if (trail.now > trail.from) canvas.line(path_V(state, trail.from, trail.now), false, color, 2.2);
  canvas.dot(Vector3d::Zero(), kCentreDot, canvas.colors.ink);
  const Vector3d point = point_V(state), velocityTip = velocityTip_V(state);
  if (byPoint_) {
    canvas.dot(point, kCentreDot, canvas.colors.ink);
    canvas.point("K", point);
    canvas.label(scene::LabelName::kReferencePoint, point, velocityTip, canvas.colors.ink);
  }
  if (position_) {
    const Vector3d origin = origin_V(state);
    canvas.dot(origin, kCentreDot, canvas.colors.ink);
    canvas.point("origin", origin);
    canvas.label(scene::LabelName::kOrigin, origin, Vector3d::Zero(), canvas.colors.ink);
    canvas.arrowFrom(origin, point, kFlightArrowRadius, canvas.colors.ink);
    const double most = follows_ ? kNearBody / std::max(origin.norm(), kNearBody) : 1;
    canvas.label(scene::LabelName::kR, point + std::min(kNameOfR, most) * (origin - point),
                 origin + Vector3d::UnitX(), canvas.colors.ink);
  }
  if (velocity_ && velocityTip != point) {
    canvas.arrowFrom(point, velocityTip, kFlightArrowRadius, color);
    canvas.point("V", velocityTip);
    canvas.label(scene::LabelName::kV, velocityTip, point, color);
  }
  if (weight_ && !weight_W_.isZero(0)) {
    canvas.arrow(weightTip_V(state), kFlightArrowRadius, canvas.colors.torque);
    canvas.point("weight", weightTip_V(state));
    canvas.label(scene::LabelName::kWeight, weightTip_V(state), Vector3d::Zero(), canvas.colors.torque);
  }
}

std::vector<Vector3d> FlightFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points{Vector3d::Zero(), point_V(state)};
  if (position_ && !follows_) points.push_back(origin_V(state));
  if (velocity_) points.push_back(velocityTip_V(state));
  if (weight_) points.push_back(weightTip_V(state));
  return points;
}

TotalAngularMomentumFigure::TotalAngularMomentumFigure(const Setting& setting)
    : placeScale_(setting.scales.flight),
      scale_(setting.scales.L * setting.scene.show.figures.totalL.scale),
      torqueScale_(0),
      torque_(setting.scene.show.figures.totalL.torque) {
  POINSOT_EXPECT(setting.motion.flight() && setting.scene.body.mass);
  mass_kg_ = setting.scene.body.mass->mass_kg();
  weight_W_ = mass_kg_ * setting.motion.flight()->gravity_W;
  double longest = 0;
  for (const PathPoint& p : setting.motion.outline())
    longest = std::max(longest, setting.motion.atPlayed(p.played_s).centre_V.cross(weight_W_).norm());
  if (longest > 0) torqueScale_ = kLongestWeightTorque / longest;
}

Vector3d TotalAngularMomentumFigure::orbital_V(const PictureState& state) const {
  return scale_ * mass_kg_ * state.centre_V.cross(state.velocity_V);
}

Vector3d TotalAngularMomentumFigure::torque_V(const PictureState& state) const {
  return torqueScale_ * state.centre_V.cross(state.R_VW * weight_W_);
}

void TotalAngularMomentumFigure::add(const Canvas& canvas, double /*filmTime_s*/,
                                     const PictureState& state) const {
  const Vector3d origin = origin_V(state), corner = origin + orbital_V(state), tip = origin + total_V(state);
  const draw::Color parts = mixed(canvas.colors.L, canvas.colors.paper, 0.6);
  const auto arrow = [&](const Vector3d& from, const Vector3d& to, const draw::Color& color) {
    if (!(to - from).isZero(0)) canvas.arrowFrom(from, to, kFlightArrowRadius, color);
  };
  arrow(origin, corner, parts);
  arrow(corner, tip, parts);
  arrow(origin, tip, canvas.colors.L);
  canvas.point("orbital-L", corner);
  canvas.point("total-L", tip);
  canvas.label(scene::LabelName::kOrbitalL, corner, origin, canvas.colors.L);
  canvas.label(scene::LabelName::kTotalL, tip, origin, canvas.colors.L);
  canvas.label(scene::LabelName::kL, corner + kNameOfL * (tip - corner), corner, canvas.colors.L);
  if (!torque_) return;
  arrow(origin, origin + torque_V(state), canvas.colors.torque);
  canvas.point("torque-about-origin", origin + torque_V(state));
  canvas.label(scene::LabelName::kTorqueAboutOrigin, origin + torque_V(state), origin, canvas.colors.torque);
}

std::vector<Vector3d> TotalAngularMomentumFigure::outermostPoints(const PictureState& state) const {
  const Vector3d origin = origin_V(state);
  std::vector<Vector3d> points{origin, origin + orbital_V(state), origin + total_V(state)};
  if (torque_) points.emplace_back(origin + torque_V(state));
  return points;
}

}  // namespace poinsot::stage
