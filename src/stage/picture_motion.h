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

/// The motion as the picture shows it. V: the picture's axes, z up: inertial axes, or the body's turned so that
/// the axis it spins about points up, or those in which the axis k of a symmetric body and L stand still (k to the
/// right, as most cameras see it). V's origin is the point that the body turns about: where a thrown body moves
/// along, it is space that goes the other way, with the camera. Still in SI units; scaling comes later (scales.h).
struct PictureState {
  Eigen::Matrix3d R_VB;
  Eigen::Matrix3d R_VP;  ///< principal axes
  Eigen::Matrix3d R_VW;
  Eigen::Vector3d omega_V;
  Eigen::Vector3d omega_P;
  Eigen::Vector3d L_V;
  Eigen::Vector3d L_W;
  Eigen::Vector3d torque_V;    ///< N·m
  Eigen::Vector3d centre_V;    ///< the centre of mass from the origin of space, m; zero unless it moves along
  Eigen::Vector3d velocity_V;  ///< of the centre of mass, m/s; zero unless it moves along

  /// Of a point of the body, m from the fixed point, m/s: V + omega × r of one that moves along.
  Eigen::Vector3d velocityAt(const Eigen::Vector3d& r_B) const;
  bool atRest() const { return omega_P.isZero(0); }
};

using scene::chosenSpeed;

/// The motion that the scene's film shows, over the film: with larger angles where it says so.
/// @throws core::Error(kScene) where larger angles would be another kind of motion, kPhysics where it has no
/// solution.
std::shared_ptr<const physics::Motion> drawnMotion(const scene::Scene& scene);

/// From film time to the time of drawnMotion(), through the scene's changes of speed.
scene::FilmClock filmClock(const scene::Scene& scene);

/// One sample of the path of the tip of omega.
struct PathPoint {
  double played_s;
  Eigen::Vector3d omega_P;  ///< in principal axes
  Eigen::Vector3d omega_W;
  Eigen::Vector3d L_W;
};

/// What of a path has been travelled and what is to come, in played times: [from, recent] a while ago, [recent,
/// now] just now, [now, end] soon. Where a film repeats, all of it has been travelled once before it begins.
struct Trail {
  double from, recent, now, end;
};

/// Axes that turn about L.
struct Precession {
  Eigen::Matrix3d R_VW = Eigen::Matrix3d::Identity();  ///< at motion time 0
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();   ///< unit
  double rate = 0;                                     ///< rad per motion second
};

/// Paths are functions of the played time (scene/motion/film_clock.h), on which changes of speed do not tell: it
/// runs slower where the motion does, and stands still with it.
class PictureMotion {
 public:
  /// `motion`: drawnMotion() of the scene; its views share it.
  PictureMotion(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion);

  PictureState at(double filmTime_s) const { return atPlayed(played_s(filmTime_s)); }
  PictureState atPlayed(double played_s) const;
  double played_s(double filmTime_s) const { return clock_.played_s(filmTime_s); }

  PathPoint pathPoint(double played_s) const;
  /// The tip of omega from one played time to another, dense enough to look smooth. The inner points lie on a grid
  /// of times that is the same for every frame, so that a curve does not crawl; at most `kMostPathPoints`.
  std::vector<PathPoint> path(double from_s, double to_s) const;
  /// The longest stretch of played time that path() can show.
  double longestPath_s() const { return pathStep_s_ * static_cast<double>(kMostPathPoints - 2); }
  /// At a film time, no stretch longer than `longest_s`.
  Trail trail(double filmTime_s, double longest_s) const;
  /// A few hundred points of the path over the whole film: enough to know how far it reaches.
  const std::vector<PathPoint>& outline() const { return outline_; }
  /// The point of the outline where the kinetic energy is greatest; of a free motion, the first.
  const PathPoint& liveliest() const { return outline_[liveliest_]; }

  const physics::PrincipalAxes& axes() const { return motion_->axes(); }
  const physics::PrincipalMoments& moments() const { return axes().moments(); }
  /// Of a body that moves along in the picture; else none.
  const std::optional<physics::Flight>& flight() const { return flight_; }
  /// Nothing acts on the body: L and the energy are constant.
  bool isFree() const { return forcing_.none(); }
  /// Seconds of motion per second of played time.
  double speed() const { return clock_.speed(); }
  /// Played time of the whole film.
  double length_s() const { return length_s_; }

 private:
  static constexpr std::size_t kMostPathPoints = 6000;

  Eigen::Matrix3d R_VW(double played_s, const physics::RigidBodyState& state) const;
  physics::RigidBodyState stateAt(double played_s) const { return motion_->at(clock_.motionTimeOf(played_s)); }

  std::shared_ptr<const physics::Motion> motion_;
  scene::FilmClock clock_;
  double length_s_;  // of played time
  bool repeats_;
  physics::Forcing forcing_;
  std::optional<physics::Flight> flight_;
  scene::CameraFrame frame_;
  Eigen::Matrix3d R_VB_;   // where the body stands, when it does
  Precession precession_;  // of the picture's axes, when they precess
  std::vector<PathPoint> outline_;
  std::size_t liveliest_;
  double pathStep_s_;  // of played time
};

static_assert(core::laidOut<PictureState, 384>());

}  // namespace poinsot::stage
