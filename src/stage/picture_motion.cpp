// SPDX-License-Identifier: Apache-2.0
#include "stage/picture_motion.h"

#include <algorithm>
#include <cmath>

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Above about a turn a second the eye loses the rolling, below a twelfth nothing seems to move.
constexpr double kCalmestSpin = 0.5, kFastestSpin = 6.5, kPleasantSpin = 2.1;  // rad per film second

constexpr double kPathStep_rad = 0.06;  // 105 points a turn: 0.1 px off a circle of 200 px
constexpr std::size_t kFewestPoints = 64, kMostPoints = 12000;

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

physics::FreeMotion makeMotion(const scene::Scene& scene) {
  const Vector3d omega_B = exaggerated(scene.motion.omega_B, scene.show.exaggerateAngles);
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

}  // namespace

PictureMotion::PictureMotion(const scene::Scene& scene)
    : motion_(makeMotion(scene)),
      start_s_(scene.time.start_s),
      speed_(chosenSpeed(scene)),
      duration_s_(scene.time.duration_s),
      bodyStandsStill_(scene.camera.frame == scene::CameraFrame::kBody),
      R_VB_(standingBody(scene)),
      path_(samplePath()) {}

PathPoint PictureMotion::pathPoint(double filmTime_s) const {
  const auto state = motion_.at(start_s_ + speed_ * filmTime_s);
  return {filmTime_s, state.omega_B, state.omega_W};
}

std::vector<PathPoint> PictureMotion::samplePath() const {
  // The tip of omega turns about L at most at |L| / (smallest moment).
  const double fastest = motion_.L_W().norm() / motion_.moments().values().minCoeff();
  const double turned = std::abs(speed_) * duration_s_ * fastest;
  const auto wanted = static_cast<std::size_t>(std::min(turned / kPathStep_rad, 1e9));
  const std::size_t n = std::clamp(wanted, kFewestPoints, kMostPoints);
  std::vector<PathPoint> path;
  path.reserve(n + 1);
  for (std::size_t i = 0; i <= n; ++i)
    path.push_back(pathPoint(duration_s_ * static_cast<double>(i) / static_cast<double>(n)));
  return path;
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
