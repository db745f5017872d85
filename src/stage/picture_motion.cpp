// SPDX-License-Identifier: Apache-2.0
#include "stage/picture_motion.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Above about a turn a second the eye loses the rolling, below a twelfth nothing seems to move.
constexpr double kCalmestSpin = 0.5, kFastestSpin = 6.5, kPleasantSpin = 2.1;  // rad per film second

constexpr double kPathStep = 0.06;  // of a circle's radius: 105 points a turn, 0.1 px off a circle of 200 px
constexpr int kOutlinePoints = 600;

int spinAxis(const Vector3d& omega_B) {
  int axis = 0;
  omega_B.cwiseAbs().maxCoeff(&axis);
  return axis;
}

// The motion of the same body with its small transverse omega drawn larger: an exact motion too.
Vector3d exaggerated(const Vector3d& omega_B, double factor) {
  Vector3d shown = factor * omega_B;
  const int axis = spinAxis(omega_B);
  shown[axis] = omega_B[axis];
  return shown;
}

bool planeIsShown(const scene::Scene& scene) { return scene.show.plane.visible; }

Vector3d wantedDirectionOfL(const scene::Scene& scene) {
  const bool down = scene.motion.lPoints == scene::LPoints::kDown ||
                    (scene.motion.lPoints == scene::LPoints::kAuto && planeIsShown(scene));
  return {0, 0, down ? -1.0 : 1.0};
}

Quaterniond startOrientation(const scene::Scene& scene, const Vector3d& omega_B) {
  if (scene.motion.orientation_WB) return *scene.motion.orientation_WB;
  return Quaterniond::FromTwoVectors(scene.body.moments.angularMomentum(omega_B), wantedDirectionOfL(scene));
}

// Which axis the polhode goes round: the sign of L² - 2T I2 (I2 the middle moment), in units of I2².
bool roundLargest(const physics::PrincipalMoments& moments, const Vector3d& omega_B) {
  const Vector3d& I = moments.values();
  const double middle = I.sum() - I.maxCoeff() - I.minCoeff();
  const Vector3d m = I.cwiseProduct(omega_B) / middle;
  return m.dot(m - omega_B) >= 0;
}

// Larger angles must stay the same kind of motion, or the picture would not be true in any sense.
void checkExaggeration(const scene::Scene& scene, const Vector3d& drawn_B) {
  const Vector3d& omega_B = scene.motion.omega_B;
  const bool sameAxis = spinAxis(drawn_B) == spinAxis(omega_B);
  if (sameAxis && roundLargest(scene.body.moments, drawn_B) == roundLargest(scene.body.moments, omega_B)) return;
  throw core::Error(
      core::ErrorKind::kScene,
      "show.exaggerate_angles: drawn that much larger, the motion would be of another kind; choose less");
}

physics::FreeMotion makeMotion(const scene::Scene& scene) {
  const Vector3d omega_B = exaggerated(scene.motion.omega_B, scene.show.exaggerateAngles);
  if (scene.show.exaggerateAngles > 1) checkExaggeration(scene, omega_B);
  return {scene.body.moments, omega_B, startOrientation(scene, omega_B)};
}

double chosenSpeed(const scene::Scene& scene) {
  if (scene.time.speed) return *scene.time.speed;
  const double spin = scene.motion.omega_B.norm();
  return spin == 0 || (spin >= kCalmestSpin && spin <= kFastestSpin) ? 1.0 : kPleasantSpin / spin;
}

// The body standing with its spin axis up (down where L points down).
Matrix3d standingBody(const scene::Scene& scene) {
  const int axis = spinAxis(scene.motion.omega_B);
  const double sign = scene.motion.omega_B[axis] < 0 ? -1 : 1;
  const Vector3d up = wantedDirectionOfL(scene);
  return Quaterniond::FromTwoVectors(sign * Vector3d::Unit(axis), up).toRotationMatrix();
}

// Rate of change of omega in the body, and so in space too (eq 30, 31): I⁻¹ (I omega x omega).
double tipSpeed(const physics::PrincipalMoments& moments, const Vector3d& omega_B) {
  return moments.angularMomentum(omega_B).cross(omega_B).cwiseQuotient(moments.values()).norm();
}

// Film time in which the tip of omega goes, where it is fastest, by a small part of its greatest distance from L.
double pathStep(const PictureMotion& motion) {
  const Vector3d up = motion.motion().L_W().normalized();
  double fastest = 0, farthest = 0;
  for (const PathPoint& p : motion.outline()) {
    fastest = std::max(fastest, std::abs(motion.speed()) * tipSpeed(motion.motion().moments(), p.omega_B));
    farthest = std::max(farthest, up.cross(p.omega_W).norm());
  }
  const double coarsest = motion.duration_s() / 64;
  return fastest > 0 && farthest > 0 ? std::min(kPathStep * farthest / fastest, coarsest) : coarsest;
}

}  // namespace

PictureMotion::PictureMotion(const scene::Scene& scene)
    : motion_(makeMotion(scene)),
      start_s_(scene.time.start_s),
      speed_(chosenSpeed(scene)),
      duration_s_(scene.time.duration_s),
      bodyStandsStill_(scene.camera.frame == scene::CameraFrame::kBody),
      R_VB_(standingBody(scene)),
      pathStep_s_(pathStep(*this)) {}

PathPoint PictureMotion::pathPoint(double filmTime_s) const {
  const auto state = motion_.at(start_s_ + speed_ * filmTime_s);
  return {filmTime_s, state.omega_B, state.omega_W};
}

std::vector<PathPoint> PictureMotion::path(double from_s, double to_s) const {
  std::vector<PathPoint> points{pathPoint(from_s)};
  const double last = std::ceil(to_s / pathStep_s_);
  for (double k = std::floor(from_s / pathStep_s_) + 1; k < last && points.size() + 1 < kMostPathPoints; ++k)
    points.push_back(pathPoint(k * pathStep_s_));
  points.push_back(pathPoint(to_s));
  return points;
}

std::vector<PathPoint> PictureMotion::outline() const {
  std::vector<PathPoint> points;
  for (int i = 0; i <= kOutlinePoints; ++i) points.push_back(pathPoint(duration_s_ * i / kOutlinePoints));
  return points;
}

Matrix3d PictureMotion::R_VW(double filmTime_s) const {
  if (!bodyStandsStill_) return Matrix3d::Identity();
  return R_VB_ * motion_.at(start_s_ + speed_ * filmTime_s).q_WB.toRotationMatrix().transpose();
}

PictureState PictureMotion::at(double filmTime_s) const {
  const auto state = motion_.at(start_s_ + speed_ * filmTime_s);
  const Matrix3d R_WB = state.q_WB.toRotationMatrix();
  const Matrix3d R_VW = bodyStandsStill_ ? Matrix3d(R_VB_ * R_WB.transpose()) : Matrix3d(Matrix3d::Identity());
  return {R_VW * R_WB, R_VW, R_VW * state.omega_W, R_VW * motion_.L_W()};
}

}  // namespace poinsot::stage
