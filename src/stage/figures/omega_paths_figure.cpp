// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/omega_paths_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "physics/polhode.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr int kPolhodePoints = 400, kFramedPathPoints = 24;
constexpr double kWholeRadius = 0.007, kTravelledRadius = 0.011;

std::vector<Vector3d> pointsOf(const physics::Polhode& polhode) {
  std::vector<Vector3d> points;
  for (const auto& sample : polhode.samples(kPolhodePoints)) points.push_back(sample.omega_P);
  return points;
}

}  // namespace

PolhodeFigure::PolhodeFigure(const Setting& setting)
    : motion_(setting.motion),
      scale_(setting.construction->scale()),
      onEllipsoid_(setting.scene.show.ellipsoid.visible),
      period_s_(std::numeric_limits<double>::infinity()) {
  if (!motion_.isFree()) return;
  const PathPoint& start = motion_.liveliest();
  const physics::Polhode polhode(motion_.moments(), start.omega_P);
  const double speed = std::max(std::abs(motion_.speed()), std::numeric_limits<double>::min());
  period_s_ = polhode.period() / speed;
  for (const auto& sample : polhode.samples(kPolhodePoints))
    free_.push_back({start.played_s + std::copysign(sample.t_s / speed, motion_.speed()), sample.omega_P});
}

void PolhodeFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  if (state.atRest()) return;
  const Trail trail = motion_.trail(filmTime_s, motion_.longestPath_s());
  const double from = std::max({trail.from, trail.now - period_s_, trail.now - motion_.longestPath_s()});
  addUntravelled(canvas, state, trail.now, from);
  std::vector<Vector3d> points;
  for (const PathPoint& p : motion_.path(from, trail.now)) points.push_back(p.omega_P);
  addTube(canvas, state, points, false, kTravelledRadius, canvas.colors.polhode);
}

std::vector<Vector3d> PolhodeFigure::untravelled(double now_s, double from_s) const {
  std::vector<Vector3d> points;
  if (!(period_s_ > 0 && std::isfinite(period_s_))) {
    for (const Sample& sample : free_) points.push_back(sample.omega_P);
    return points;
  }
  std::map<double, Vector3d> coming;
  for (const Sample& sample : free_) {
    const double turns = (sample.played_s - now_s) / period_s_;
    coming.emplace((turns - std::floor(turns)) * period_s_, sample.omega_P);
  }
  points.push_back(motion_.pathPoint(now_s).omega_P);
  for (const auto& [s, omega_P] : coming)
    if (s < period_s_ - (now_s - from_s)) points.push_back(omega_P);
  if (points.size() == 1) return {};
  points.push_back(motion_.pathPoint(from_s).omega_P);
  return points;
}

void PolhodeFigure::addUntravelled(const Canvas& canvas, const PictureState& state, double now_s,
                                   double from_s) const {
  if (motion_.isFree())
    return addTube(canvas, state, untravelled(now_s, from_s), false, kWholeRadius, canvas.colors.futurePolhode);
  const physics::Polhode polhode(motion_.moments(), state.omega_P);
  addTube(canvas, state, pointsOf(polhode), std::isfinite(polhode.period()), kWholeRadius,
          canvas.colors.futurePolhode);
}

void PolhodeFigure::addTube(const Canvas& canvas, const PictureState& state, const std::vector<Vector3d>& omega_P,
                            bool closed, double radius, const draw::Color& color) const {
  std::vector<Vector3d> points_V;
  for (const Vector3d& p : omega_P) points_V.push_back(scale_ * (state.R_VP * p));
  canvas.tube(points_V, closed, radius, color);
}

// The polhode rotates with the body. If the ellipsoid is shown, it contains the polhode, so only the tip of omega
// is returned.
std::vector<Vector3d> PolhodeFigure::outermostPoints(const PictureState& state) const {
  if (onEllipsoid_ || state.atRest()) return {scale_ * state.omega_V};
  std::vector<Vector3d> points_V;
  for (const auto& sample : physics::Polhode(motion_.moments(), state.omega_P).samples(kFramedPathPoints))
    points_V.push_back(scale_ * (state.R_VP * sample.omega_P));
  return points_V;
}

HerpolhodeFigure::HerpolhodeFigure(const Setting& setting)
    : motion_(setting.motion),
      scale_(setting.construction->scale()),
      future_(setting.scene.show.herpolhode.future) {}

void HerpolhodeFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  const Trail trail = motion_.trail(filmTime_s, motion_.longestPath_s());
  const Palette& colors = canvas.colors;
  if (future_) addPath(canvas, state, trail.now, trail.end, colors.futureHerpolhode, 1.2, 0.004);
  addPath(canvas, state, trail.from, trail.recent, colors.herpolhode, 1.7, 0.008);
  addPath(canvas, state, trail.recent, trail.now, colors.herpolhode, 2.9, 0.012);
}

void HerpolhodeFigure::addPath(const Canvas& canvas, const PictureState& state, double from_s, double to_s,
                               const draw::Color& color, double width, double lift) const {
  if (!(to_s > from_s)) return;
  std::vector<Vector3d> points_V;
  for (const PathPoint& p : motion_.path(from_s, to_s)) points_V.push_back(scale_ * (state.R_VW * p.omega_W));
  canvas.line(points_V, false, color, width, lift);
}

std::vector<Vector3d> HerpolhodeFigure::outermostPoints(const PictureState& state) const {
  return {scale_ * state.omega_V};
}

}  // namespace poinsot::stage
