// SPDX-License-Identifier: Apache-2.0
#include "stage/picture_motion.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "physics/precession_cones.h"
#include "scene/make_motion.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Above about a turn a second the eye loses the rolling, below a twelfth nothing seems to move.
constexpr double kCalmestSpin = 0.5, kFastestSpin = 6.5, kPleasantSpin = 2.1;  // rad per film second

constexpr double kPathStep = 0.06;  // of a circle's radius: 105 points a turn, 0.1 px off a circle of 200 px
constexpr int kOutlinePoints = 600;

int spinAxis(const Vector3d& omega_P) {
  int axis = 0;
  omega_P.cwiseAbs().maxCoeff(&axis);
  return axis;
}

// The motion of the same body with its small transverse omega drawn larger: an exact motion too.
Vector3d exaggerated(const Vector3d& omega_P, double factor) {
  Vector3d shown = factor * omega_P;
  const int axis = spinAxis(omega_P);
  shown[axis] = omega_P[axis];
  return shown;
}

// Which axis the polhode goes round: the sign of L² - 2T I2 (I2 the middle moment), in units of I2².
bool roundLargest(const physics::PrincipalMoments& moments, const Vector3d& omega_P) {
  const Vector3d& I = moments.values();
  const double middle = I.sum() - I.maxCoeff() - I.minCoeff();
  const Vector3d m = I.cwiseProduct(omega_P) / middle;
  return m.dot(m - omega_P) >= 0;
}

// Larger angles must stay the same kind of motion, or the picture would not be true in any sense.
void checkExaggeration(const physics::PrincipalMoments& moments, const Vector3d& omega_P,
                       const Vector3d& drawn_P) {
  const bool sameAxis = spinAxis(drawn_P) == spinAxis(omega_P);
  if (sameAxis && roundLargest(moments, drawn_P) == roundLargest(moments, omega_P)) return;
  throw core::Error(
      core::ErrorKind::kScene,
      "show.exaggerate_angles: drawn that much larger, the motion would be of another kind; choose less");
}

// The body standing with its spin axis up (down where L points down).
Matrix3d standingBody(const scene::Scene& scene) {
  const Vector3d omega_P = scene.body.axes.toP(scene.motion.omega_B);
  const int axis = spinAxis(omega_P);
  const Vector3d spin_B = scene.body.axes.toB((omega_P[axis] < 0 ? -1 : 1) * Vector3d::Unit(axis));
  return Quaterniond::FromTwoVectors(spin_B, scene::directionOfL(scene)).toRotationMatrix();
}

// V's z is up or down L as the scene has it; at time 0 the body's axis k lies in V's half plane of y and z.
Precession precessionOf(const scene::Scene& scene, const physics::Motion& motion) {
  const physics::RigidBodyState start = motion.at(0);
  const auto cones = physics::precessionCones(motion.axes().moments(), motion.axes().toP(start.omega_B));
  POINSOT_EXPECT(cones);  // a scene with another body has no such view
  const Vector3d along_W = start.L_W.normalized(), up_W = scene::directionOfL(scene).z() * along_W;
  const Vector3d k_W = start.q_WB * motion.axes().toB(cones->k_P);
  // Of a body that spins about k, any direction will do.
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
    points.push_back(motion.pathPoint(motion.duration_s() * i / kOutlinePoints));
  return points;
}

// More than by rounding: of a free motion it is the first.
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

// Of the tip of omega, per film time, the same in the body and in space (eq 30, 31): from a difference over a time
// in which the body turns by a ten thousandth of a turn.
double tipSpeed(const PictureMotion& motion, const PathPoint& p) {
  const double turning = std::abs(motion.speed()) * p.omega_W.norm(), longest_s = 1e-3 * motion.duration_s();
  const double step_s = turning * longest_s > 6e-4 ? 6e-4 / turning : longest_s;
  const double other_s = p.filmTime_s + (p.filmTime_s > 0.5 * motion.duration_s() ? -step_s : step_s);
  return (motion.pathPoint(other_s).omega_P - p.omega_P).norm() / step_s;
}

// Film time in which the tip of omega goes, where it is fastest, by a small part of its greatest distance from L.
double pathStep(const PictureMotion& motion) {
  double fastest = 0, farthest = 0;
  for (const PathPoint& p : motion.outline()) {
    fastest = std::max(fastest, tipSpeed(motion, p));
    if (p.L_W.norm() > 0) farthest = std::max(farthest, p.L_W.normalized().cross(p.omega_W).norm());
  }
  const double coarsest = motion.duration_s() / 64;
  return fastest > 0 && farthest > 0 ? std::min(kPathStep * farthest / fastest, coarsest) : coarsest;
}

}  // namespace

double chosenSpeed(const scene::Scene& scene) {
  if (scene.time.speed) return *scene.time.speed;
  const double spin = scene.motion.omega_B.norm();
  return spin == 0 || (spin >= kCalmestSpin && spin <= kFastestSpin) ? 1.0 : kPleasantSpin / spin;
}

std::shared_ptr<const physics::Motion> drawnMotion(const scene::Scene& scene) {
  const double end = scene.time.start_s + chosenSpeed(scene) * scene.time.duration_s;
  const double factor = scene.show.exaggerateAngles;
  if (factor == 1) return scene::makeMotion(scene, scene.time.start_s, end);
  const physics::PrincipalAxes& axes = scene.body.axes;
  const Vector3d omega_P = axes.toP(scene.motion.omega_B), drawn_P = exaggerated(omega_P, factor);
  checkExaggeration(axes.moments(), omega_P, drawn_P);
  scene::Scene drawn = scene;
  drawn.motion.omega_B = axes.toB(drawn_P);
  return scene::makeMotion(drawn, scene.time.start_s, end);
}

PictureMotion::PictureMotion(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion)
    : motion_(std::move(motion)),
      start_s_(scene.time.start_s),
      speed_(chosenSpeed(scene)),
      duration_s_(scene.time.duration_s),
      isFree_(scene.motion.forcing.none()),
      frame_(scene.camera.frame),
      R_VB_(standingBody(scene)),
      precession_(frame_ == scene::CameraFrame::kPrecession ? precessionOf(scene, *motion_) : Precession()),
      outline_(outlineOf(*this)),
      liveliest_(indexOfMostEnergy(*this, outline_)),
      pathStep_s_(pathStep(*this)) {}

PathPoint PictureMotion::pathPoint(double filmTime_s) const {
  const physics::RigidBodyState state = stateAt(filmTime_s);
  return {filmTime_s, axes().toP(state.omega_B), state.omega_W, state.L_W};
}

std::vector<PathPoint> PictureMotion::path(double from_s, double to_s) const {
  std::vector<PathPoint> points{pathPoint(from_s)};
  const double last = std::ceil(to_s / pathStep_s_);
  for (double k = std::floor(from_s / pathStep_s_) + 1; k < last && points.size() + 1 < kMostPathPoints; ++k)
    points.push_back(pathPoint(k * pathStep_s_));
  points.push_back(pathPoint(to_s));
  return points;
}

Matrix3d PictureMotion::R_VW(double filmTime_s) const { return R_VW(filmTime_s, stateAt(filmTime_s)); }

Matrix3d PictureMotion::R_VW(double filmTime_s, const physics::RigidBodyState& state) const {
  switch (frame_) {
    case scene::CameraFrame::kSpace:
      break;
    case scene::CameraFrame::kBody:
      return R_VB_ * state.q_WB.toRotationMatrix().transpose();
    case scene::CameraFrame::kPrecession: {
      const double angle = -precession_.rate * (start_s_ + speed_ * filmTime_s);
      return precession_.R_VW * Eigen::AngleAxisd(angle, precession_.axis_W).toRotationMatrix();
    }
  }
  return Matrix3d::Identity();
}

PictureState PictureMotion::at(double filmTime_s) const {
  const physics::RigidBodyState state = stateAt(filmTime_s);
  const Matrix3d R_WB = state.q_WB.toRotationMatrix();
  const Matrix3d R_VW = this->R_VW(filmTime_s, state);
  const Matrix3d R_VB = R_VW * R_WB;
  const Matrix3d R_VP = axes().aligned() ? R_VB : Matrix3d(R_VB * axes().q_BP().toRotationMatrix());
  return {R_VB, R_VP, R_VW, R_VW * state.omega_W, axes().toP(state.omega_B), R_VW * state.L_W, state.L_W};
}

}  // namespace poinsot::stage
