// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/trace_figure.h"

#include <algorithm>
#include <cmath>

#include "stage/even_times.h"
#include "stage/figures/symmetric_top.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kSphereReach = 1.1;  // radius of the sphere, as a multiple of Scales::reach
constexpr double kStep_rad = 0.015;   // angle between samples of the point on its sphere
constexpr int kMostTracePoints = 8000;
constexpr double kPaleTrace = 0.4;
constexpr double kOverPath = 0.004;  // lifts the travelled part over the part to come

// Returns the end of the body on a principal axis. The chosen axis is the one along which the body reaches
// farthest.
Vector3d endOfBody_B(const Setting& setting) {
  const Vector3d& ahead = setting.body.reachAlongAxes();
  const Vector3d behind = 2 * setting.body.halfExtents() - ahead;
  int axis = 0;
  const double most = ahead.cwiseMax(behind).maxCoeff(&axis);
  const double end = ahead[axis] == most ? most : -most;
  return setting.scales.body * end * setting.motion.axes().toB(Vector3d::Unit(axis));
}

Vector3d tracedPoint_B(const Setting& setting) {
  const auto& trace = setting.scene.show.figures.trace;
  if (trace.point_B) return setting.scales.body * (*trace.point_B - setting.scene.body.fixedPoint_B());
  if (setting.motion.flight()) return trace.scale * endOfBody_B(setting);
  return trace.scale * kSphereReach * setting.scales.reach * setting.motion.axes().toB(mainAxis_P(setting.motion));
}

// Returns the time step between samples of the path, in played time. In a step, the point moves by at most
// kStep_rad.
double stepOf(const PictureMotion& motion, const Vector3d& point_B) {
  const Vector3d direction_P = motion.axes().toP(point_B.normalized());
  double fastest = 0;
  for (const PathPoint& p : motion.outline()) fastest = std::max(fastest, p.omega_P.cross(direction_P).norm());
  const double coarsest = motion.length_s() / 64, rate = fastest * std::abs(motion.speed());
  return rate > 0 ? std::min(kStep_rad / rate, coarsest) : coarsest;
}

}  // namespace

TraceFigure::TraceFigure(const Setting& setting)
    : motion_(setting.motion),
      point_B_(tracedPoint_B(setting)),
      flightScale_(setting.scales.flight),
      opacity_(setting.motion.flight() ? 0 : setting.scene.show.figures.trace.opacity),
      future_(setting.scene.show.figures.trace.future),
      step_s_(stepOf(setting.motion, point_B_)) {}

Vector3d TraceFigure::at_W(double played_s) const {
  const PictureState state = motion_.atPlayed(played_s);
  return state.R_VW.transpose() * (flightScale_ * state.centre_V + state.R_VB * point_B_);
}

std::vector<Vector3d> TraceFigure::path_W(double from_s, double to_s) const {
  std::vector<Vector3d> points;
  for (const double t_s : evenTimes(from_s, to_s, step_s_, kMostTracePoints + 3)) points.push_back(at_W(t_s));
  return points;
}

void TraceFigure::addPath(const Canvas& canvas, const PictureState& state, double from_s, double to_s,
                          const draw::Color& color, double width, double lift) const {
  if (!(to_s > from_s)) return;
  std::vector<Vector3d> points;
  for (const Vector3d& p_W : path_W(from_s, to_s))
    points.emplace_back(state.R_VW * p_W - flightScale_ * state.centre_V);
  canvas.line(points, false, color, width, lift);
}

void TraceFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  if (opacity_ > 0)
    canvas.glassEllipsoid(radius() * state.R_VW, canvas.colors.body, opacity_, {.near = 0.5, .far = 1, .rim = 5});
  const Trail trail = motion_.trail(filmTime_s, kMostTracePoints * step_s_);
  const draw::Color& color = canvas.colors.axis;
  if (future_) addPath(canvas, state, trail.now, trail.end, mixed(color, canvas.colors.paper, kPaleTrace), 1.2, 0);
  addPath(canvas, state, trail.from, trail.recent, color, 1.8, kOverPath);
  addPath(canvas, state, trail.recent, trail.now, color, 2.9, kOverPath);
  canvas.dot(point_V(state), 0.028, canvas.colors.axis);
}

// Returns the ends of the sphere along V's axes, or the traced point if no sphere is drawn.
std::vector<Vector3d> TraceFigure::outermostPoints(const PictureState& state) const {
  if (opacity_ == 0) return {point_V(state)};
  std::vector<Vector3d> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) points.emplace_back(side * radius() * Vector3d::Unit(axis));
  return points;
}

}  // namespace poinsot::stage
