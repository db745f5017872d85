// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "core/abi.h"
#include "physics/motion.h"
#include "scene/motion/film_clock.h"
#include "scene/motion/make_motion.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// State of the motion in the picture's axes V, with z up, in SI units. V are one of these axes, depending on the
/// camera:
/// - the inertial axes;
/// - axes fixed in the body, with its spin axis up;
/// - axes in which L and the axis k of a symmetric body are fixed, with k to the right in most pictures.
///
/// The origin of V is the point about which the body rotates. If a thrown body moves through the view, V moves
/// with the body. The camera and everything at rest in space then move the other way.
struct PictureState {
  Eigen::Matrix3d R_VB;
  Eigen::Matrix3d R_VP;
  Eigen::Matrix3d R_VW;
  Eigen::Vector3d omega_V;
  Eigen::Vector3d omega_P;
  Eigen::Vector3d L_V;
  Eigen::Vector3d L_W;
  Eigen::Vector3d torque_V;
  Eigen::Vector3d centre_V;    ///< position of the centre of mass in space; zero unless the body flies in the view
  Eigen::Vector3d velocity_V;  ///< velocity of the centre of mass; zero unless the body flies in the view
  double t_s = 0;              ///< motion time

  /// Returns the velocity of a body point, m/s: velocity_V + omega_V × r.
  /// @param r_B  vector from the fixed point to the body point, m
  Eigen::Vector3d velocityAt(const Eigen::Vector3d& r_B) const;
  bool atRest() const { return omega_P.isZero(0); }
};

using scene::chosenSpeed;

/// Returns the motion that the scene's film shows, with exaggerated angles if the scene sets them.
/// @throws core::Error(kScene) if exaggerated angles would change the kind of motion, kPhysics if the motion has
/// no solution.
std::shared_ptr<const physics::Motion> drawnMotion(const scene::Scene& scene);

/// Returns the clock from film time to the time of drawnMotion(), including the scene's changes of speed.
scene::FilmClock filmClock(const scene::Scene& scene);

/// Point on the path of the tip of omega.
struct PathPoint {
  double played_s;
  Eigen::Vector3d omega_P;
  Eigen::Vector3d omega_W;
  Eigen::Vector3d L_W;
};

/// Parts of a path, in played time: [from, recent] is the older part, [recent, now] the newest part, and [now,
/// end] the part still to come. In a film that repeats, the complete path counts as travelled from the beginning.
struct Trail {
  double from, recent, now, end;
};

/// Picture axes V that rotate about L at a constant rate.
struct Precession {
  Eigen::Matrix3d R_VW = Eigen::Matrix3d::Identity();  ///< axes at motion time 0
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();
  double rate = 0;  ///< rate of rotation, rad per second of motion time
};

/// Motion of a scene as its pictures show it. Paths are functions of the played time (scene/motion/film_clock.h),
/// which slows down and stops with the motion. Changes of speed therefore do not affect paths.
class PictureMotion {
 public:
  /// @param motion  drawnMotion() of the scene, shared by all views of the scene
  PictureMotion(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion);

  PictureState at(double filmTime_s) const { return atPlayed(played_s(filmTime_s)); }
  PictureState atPlayed(double played_s) const;
  double played_s(double filmTime_s) const { return clock_.played_s(filmTime_s); }

  PathPoint pathPoint(double played_s) const;
  double motionTimeOf(double played_s) const { return clock_.motionTimeOf(played_s); }
  /// Returns omega at any time of the motion, also outside the film.
  Eigen::Vector3d omegaAtMotionTime_W(double t_s) const { return motion_->at(t_s).omega_W; }
  /// Returns the path of the tip of omega between two played times. The points are dense enough to look smooth,
  /// but at most `kMostPathPoints`. Inner points lie on a time grid common to all frames, so that the curve does
  /// not shimmer.
  std::vector<PathPoint> path(double from_s, double to_s) const;
  /// Returns the longest played time that a result of path() can span.
  double longestPath_s() const { return pathStep_s_ * static_cast<double>(kMostPathPoints - 2); }
  /// Returns the parts of a path at a film time. Each part is at most `longest_s` long.
  Trail trail(double filmTime_s, double longest_s) const;
  /// Returns 601 points of the path at equal time steps over the complete film. They show how far the path
  /// reaches.
  const std::vector<PathPoint>& outline() const { return outline_; }
  /// Returns the point of outline() with the greatest kinetic energy. For a free motion, returns the first point.
  const PathPoint& liveliest() const { return outline_[liveliest_]; }

  const physics::PrincipalAxes& axes() const { return motion_->axes(); }
  const physics::PrincipalMoments& moments() const { return axes().moments(); }
  /// Returns the flight of a body that moves through the view; otherwise nullopt.
  const std::optional<physics::Flight>& flight() const { return flight_; }
  /// Returns true if nothing acts on the body, so that L and the energy are constant.
  bool isFree() const { return forcing_.none() && !rolling_; }
  /// Returns the cone that rolls on a table; otherwise nullopt.
  const std::optional<scene::Rolling>& rolling() const { return rolling_; }
  /// Returns seconds of motion per second of played time.
  double speed() const { return clock_.speed(); }
  /// Returns the played time of the complete film.
  double length_s() const { return length_s_; }

 private:
  static constexpr std::size_t kMostPathPoints = 6000;

  Eigen::Vector3d torque_W(const physics::RigidBodyState& state) const;
  Eigen::Matrix3d R_VW(double played_s, const physics::RigidBodyState& state) const;
  physics::RigidBodyState stateAt(double played_s) const { return motion_->at(clock_.motionTimeOf(played_s)); }

  std::shared_ptr<const physics::Motion> motion_;
  scene::FilmClock clock_;
  double length_s_;
  bool repeats_;
  physics::Forcing forcing_;
  std::optional<scene::Rolling> rolling_;
  std::optional<physics::Flight> flight_;
  std::optional<physics::FlightPath> path_;  // of a body that moves through the view
  scene::CameraFrame frame_;
  Eigen::Matrix3d R_VB_;
  Precession precession_;
  std::vector<PathPoint> outline_;
  std::size_t liveliest_;
  double pathStep_s_;
};

static_assert(core::laidOut<PictureState, 392>());

}  // namespace poinsot::stage
