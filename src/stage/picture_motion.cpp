// SPDX-License-Identifier: Apache-2.0
#include "stage/picture_motion.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "physics/precession_cones.h"
#include "physics/torque.h"
#include "scene/motion/make_motion.h"
#include "stage/even_times.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPathStep = 0.06;  // step along a circle, as a fraction of its radius: 105 points per turn
constexpr int kOutlinePoints = 600;
constexpr double kRecent_s = 0.9;  // film time that the bright end of a trail covers

// Returns the attitude of the body with its spin axis up, or down if L points down.
Matrix3d standingBody(const scene::Scene& scene) {
  const Vector3d omega_P = scene::startOmega_P(scene);
  const int axis = scene::spinAxis(omega_P);
  const Vector3d spin_B = scene.body.axes.toB((omega_P[axis] < 0 ? -1 : 1) * Vector3d::Unit(axis));
  return physics::turnOntoVertical(spin_B, scene::verticalOfL(scene)).toRotationMatrix();
}

// Returns axes V that rotate about L with the precession. The z axis is along L, or opposite to L if L points down
// in the scene. At time 0, the body's axis k lies in the y-z plane of V, where y >= 0.
Precession precessionOf(const scene::Scene& scene, const physics::Motion& motion) {
  const physics::RigidBodyState start = motion.at(0);
  const auto cones = physics::precessionCones(motion.axes().moments(), motion.axes().toP(start.omega_B));
  POINSOT_EXPECT(cones);  // only symmetric bodies have this view
  const bool down = scene::verticalOfL(scene) == physics::Vertical::kDown;
  const Vector3d along_W = start.L_W.normalized(), up_W = down ? -along_W : along_W;
  const Vector3d k_W = start.q_WB * motion.axes().toB(cones->k_P);
  // If the body spins about k itself, any direction perpendicular to L is suitable.
  const Vector3d across_W = cones->tilt_rad > 1e-12 ? k_W : Vector3d(up_W.unitOrthogonal());
  Precession precession{Matrix3d::Identity(), along_W, cones->precessionRate};
  precession.R_VW.row(2) = up_W;
  precession.R_VW.row(1) = (across_W - across_W.dot(up_W) * up_W).normalized();
  precession.R_VW.row(0) = precession.R_VW.row(1).cross(precession.R_VW.row(2));
  return precession;
}

double kineticEnergy(const physics::PrincipalMoments& moments, const Vector3d& omega_P) {
  return 0.5 * omega_P.dot(moments.angularMomentum(omega_P));
}

std::vector<PathPoint> outlineOf(const PictureMotion& motion) {
  std::vector<PathPoint> points;
  for (int i = 0; i <= kOutlinePoints; ++i)
    points.push_back(motion.pathPoint(motion.length_s() * i / kOutlinePoints));
  return points;
}

// Returns the index of the point with the greatest kinetic energy. Ignores differences due to rounding, so that
// the result for a free motion is the first point.
std::size_t indexOfMostEnergy(const PictureMotion& motion, const std::vector<PathPoint>& outline) {
  std::size_t best = 0;
  double most = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double energy = kineticEnergy(motion.moments(), outline[i].omega_P);
    if (!(energy > most * (1 + 1e-9))) continue;
    most = energy;
    best = i;
  }
  return best;
}

// Returns the speed of the tip of omega with respect to played time. The speed is the same in the body and in
// space (eq 30, 31). The difference quotient spans a ten-thousandth of a turn of the body.
double tipSpeed(const PictureMotion& motion, const PathPoint& p) {
  const double turning = std::abs(motion.speed()) * p.omega_W.norm(), longest_s = 1e-3 * motion.length_s();
  const double step_s = turning * longest_s > 6e-4 ? 6e-4 / turning : longest_s;
  const double other_s = p.played_s + (p.played_s > 0.5 * motion.length_s() ? -step_s : step_s);
  return (motion.pathPoint(other_s).omega_P - p.omega_P).norm() / step_s;
}

// Returns the time step of paths, in played time. During a step, the tip of omega moves by at most a small
// fraction of its greatest distance from L.
double pathStep(const PictureMotion& motion) {
  double fastest = 0, farthest = 0;
  for (const PathPoint& p : motion.outline()) {
    fastest = std::max(fastest, tipSpeed(motion, p));
    if (p.L_W.norm() > 0) farthest = std::max(farthest, p.L_W.normalized().cross(p.omega_W).norm());
  }
  const double coarsest = motion.length_s() / 64;
  return fastest > 0 && farthest > 0 ? std::min(kPathStep * farthest / fastest, coarsest) : coarsest;
}

}  // namespace

scene::FilmClock filmClock(const scene::Scene& scene) {
  return {scene.time.start_s, chosenSpeed(scene), scene.timeline};
}

std::shared_ptr<const physics::Motion> drawnMotion(const scene::Scene& scene) {
  const double start = scene.time.start_s, end = filmClock(scene).motionTime_s(scene.time.duration_s);
  // In a film that repeats, the path travelled before the first frame is that of the film before.
  const double earliest = scene.time.loop ? start - (end - start) : start;
  if (scene.show.exaggerateAngles == 1) return scene::makeMotion(scene, earliest, end);
  scene::Scene drawn = scene;
  drawn.motion.omega_B = scene.body.axes.toB(scene::drawnOmega_P(scene));
  return scene::makeMotion(drawn, earliest, end);
}

PictureMotion::PictureMotion(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion)
    : motion_(std::move(motion)),
      clock_(filmClock(scene)),
      length_s_(clock_.played_s(scene.time.duration_s)),
      repeats_(scene.time.loop.has_value()),
      forcing_(scene.motion.forcing),
      rolling_(scene.motion.rolling),
      flight_(scene::movesAlong(scene.motion, scene.camera, scene.show) ? scene.motion.flight : std::nullopt),
      path_(flight_ ? scene::flightPath(scene, *motion_) : std::nullopt),
      frame_(scene.camera.frame),
      R_VB_(standingBody(scene)),
      precession_(frame_ == scene::CameraFrame::kPrecession ? precessionOf(scene, *motion_) : Precession()),
      outline_(outlineOf(*this)),
      liveliest_(indexOfMostEnergy(*this, outline_)),
      pathStep_s_(pathStep(*this)) {}

Eigen::Vector3d PictureState::velocityAt(const Eigen::Vector3d& r_B) const {
  return velocity_V + omega_V.cross(R_VB * r_B);
}

PathPoint PictureMotion::pathPoint(double played_s) const {
  const physics::RigidBodyState state = stateAt(played_s);
  return {played_s, axes().toP(state.omega_B), state.omega_W, state.L_W};
}

std::vector<PathPoint> PictureMotion::path(double from_s, double to_s) const {
  std::vector<PathPoint> points;
  for (const double t_s : evenTimes(from_s, to_s, pathStep_s_, kMostPathPoints)) points.push_back(pathPoint(t_s));
  return points;
}

Trail PictureMotion::trail(double filmTime_s, double longest_s) const {
  const double now = played_s(filmTime_s), begin = repeats_ ? now - length_s_ : 0;
  const double recent = repeats_ ? now - kRecent_s : played_s(std::max(0.0, filmTime_s - kRecent_s));
  const double from = std::max({begin, recent, now - longest_s});
  return {std::max(begin, from - longest_s), from, now, repeats_ ? now : std::min(length_s_, now + longest_s)};
}

// On a table, weight and normal force turn L about the vertical.
Vector3d PictureMotion::torque_W(const physics::RigidBodyState& state) const {
  if (rolling_) return rolling_->cone.rate * Vector3d::UnitZ().cross(state.L_W);
  return physics::torque_W(forcing_, axes(), state);
}

Matrix3d PictureMotion::R_VW(double played_s, const physics::RigidBodyState& state) const {
  switch (frame_) {
    case scene::CameraFrame::kSpace:
      break;
    case scene::CameraFrame::kBody:
      return R_VB_ * state.q_WB.toRotationMatrix().transpose();
    case scene::CameraFrame::kPrecession: {
      const double angle = -precession_.rate * clock_.motionTimeOf(played_s);
      return precession_.R_VW * Eigen::AngleAxisd(angle, precession_.axis_W).toRotationMatrix();
    }
  }
  return Matrix3d::Identity();
}

PictureState PictureMotion::atPlayed(double played_s) const {
  const physics::RigidBodyState state = stateAt(played_s);
  const Matrix3d R_WB = state.q_WB.toRotationMatrix();
  const Matrix3d R_VW = this->R_VW(played_s, state);
  const Matrix3d R_VB = R_VW * R_WB;
  const Matrix3d R_VP = axes().aligned() ? R_VB : Matrix3d(R_VB * axes().q_BP().toRotationMatrix());
  return {R_VB,
          R_VP,
          R_VW,
          R_VW * state.omega_W,
          axes().toP(state.omega_B),
          R_VW * state.L_W,
          state.L_W,
          R_VW * torque_W(state),
          path_ ? Vector3d(R_VW * path_->positionAt(state.t_s)) : Vector3d::Zero(),
          path_ ? Vector3d(R_VW * path_->velocityAt(state.t_s)) : Vector3d::Zero(),
          state.t_s};
}

}  // namespace poinsot::stage
