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

/// State of the motion in the picture's axes V, z up, in SI units; scaling to lengths in the picture comes later
/// (scales.h). V are the inertial axes, or axes fixed in the body with its spin axis up, or axes in which L and
/// the axis k of a symmetric body stand still (k to the right, as most cameras see it). V's origin is the point
/// that the body turns about. If a thrown body moves through the view, space moves the other way, together with
/// the camera.
struct PictureState {
  Eigen::Matrix3d R_VB;
  Eigen::Matrix3d R_VP;
  Eigen::Matrix3d R_VW;
  Eigen::Vector3d omega_V;
  Eigen::Vector3d omega_P;
  Eigen::Vector3d L_V;
  Eigen::Vector3d L_W;
  Eigen::Vector3d torque_V;
  Eigen::Vector3d centre_V;    ///< centre of mass from the origin of space; zero unless the body flies in the view
  Eigen::Vector3d velocity_V;  ///< velocity of the centre of mass; zero unless the body flies in the view

  /// Returns the velocity of a body point, m/s: V + omega × r, where V is the velocity of the centre of mass.
  /// @param r_B  from the fixed point to the body point, m
  Eigen::Vector3d velocityAt(const Eigen::Vector3d& r_B) const;
  bool atRest() const { return omega_P.isZero(0); }
};

using scene::chosenSpeed;

/// Returns the motion that the scene's film shows, with exaggerated angles if the scene sets them.
/// @throws core::Error(kScene) if larger angles would be another kind of motion, kPhysics if it has no solution.
std::shared_ptr<const physics::Motion> drawnMotion(const scene::Scene& scene);

/// Returns the clock from film time to the time of drawnMotion(), including the scene's changes of speed.
scene::FilmClock filmClock(const scene::Scene& scene);

/// Sample of the path of the tip of omega.
struct PathPoint {
  double played_s;
  Eigen::Vector3d omega_P;
  Eigen::Vector3d omega_W;
  Eigen::Vector3d L_W;
};

/// Parts of a path in played time: [from, recent] travelled a while ago, [recent, now] travelled just now, [now,
/// end] still to come. A film that repeats has travelled the whole path once before it begins.
struct Trail {
  double from, recent, now, end;
};

/// Picture axes that turn about L at a constant rate.
struct Precession {
  Eigen::Matrix3d R_VW = Eigen::Matrix3d::Identity();  ///< axes at motion time 0
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();
  double rate = 0;  ///< rate of turning, rad per second of motion time
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
  /// Returns the path of omega's tip between two played times, dense enough to look smooth, with at most
  /// `kMostPathPoints` points. Inner points lie on a time grid common to all frames, so that the curve does not
  /// shimmer.
  std::vector<PathPoint> path(double from_s, double to_s) const;
  /// Returns the longest played time that path() can show.
  double longestPath_s() const { return pathStep_s_ * static_cast<double>(kMostPathPoints - 2); }
  /// Returns the parts of a path at a film time, none longer than `longest_s`.
  Trail trail(double filmTime_s, double longest_s) const;
  /// Returns 601 points of the path at equal steps over the whole film, enough to show how far the path reaches.
  const std::vector<PathPoint>& outline() const { return outline_; }
  /// Returns the point of the outline with the greatest kinetic energy; the first point of a free motion.
  const PathPoint& liveliest() const { return outline_[liveliest_]; }

  const physics::PrincipalAxes& axes() const { return motion_->axes(); }
  const physics::PrincipalMoments& moments() const { return axes().moments(); }
  /// Returns the flight of a body that moves through the view; otherwise nullopt.
  const std::optional<physics::Flight>& flight() const { return flight_; }
  /// Returns true if nothing acts on the body, so that L and the energy are constant.
  bool isFree() const { return forcing_.none(); }
  /// Returns seconds of motion per second of played time.
  double speed() const { return clock_.speed(); }
  /// Returns the played time of the whole film.
  double length_s() const { return length_s_; }

 private:
  static constexpr std::size_t kMostPathPoints = 6000;

  Eigen::Matrix3d R_VW(double played_s, const physics::RigidBodyState& state) const;
  physics::RigidBodyState stateAt(double played_s) const { return motion_->at(clock_.motionTimeOf(played_s)); }

  std::shared_ptr<const physics::Motion> motion_;
  scene::FilmClock clock_;
  double length_s_;
  bool repeats_;
  physics::Forcing forcing_;
  std::optional<physics::Flight> flight_;
  scene::CameraFrame frame_;
  Eigen::Matrix3d R_VB_;
  Precession precession_;
  std::vector<PathPoint> outline_;
  std::size_t liveliest_;
  double pathStep_s_;
};

static_assert(core::laidOut<PictureState, 384>());

}  // namespace poinsot::stage
