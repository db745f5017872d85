// SPDX-License-Identifier: Apache-2.0
#include "scene/motion/make_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "scene/limits.h"
#include "scene/motion/film_pace.h"

namespace poinsot::scene {
namespace {

Eigen::Vector3d exaggerated(const Eigen::Vector3d& omega_P, int axis, double factor) {
  Eigen::Vector3d shown = factor * omega_P;
  shown[axis] = omega_P[axis];
  return shown;
}

// Returns whether the polhode encloses the axis of the largest moment. This is so if L² >= 2T I2, where I2 is the
// middle moment. Compares both sides in units of I2².
bool roundLargest(const physics::PrincipalMoments& moments, const Eigen::Vector3d& omega_P) {
  const Eigen::Vector3d& I = moments.values();
  const double middle = I.sum() - I.maxCoeff() - I.minCoeff();
  const Eigen::Vector3d m = I.cwiseProduct(omega_P) / middle;
  return m.dot(m - omega_P) >= 0;
}

}  // namespace

physics::Vertical verticalOfL(const Scene& scene) {
  const bool plane = std::ranges::any_of(scene.views, [](const View& view) { return view.show.plane.visible; });
  const bool down = scene.motion.lPoints == LPoints::kDown || (scene.motion.lPoints == LPoints::kAuto && plane);
  return down ? physics::Vertical::kDown : physics::Vertical::kUp;
}

physics::Quaternion startOrientation(const Scene& scene) {
  if (scene.motion.orientation_WB) return *scene.motion.orientation_WB;
  return physics::levelAttitude(scene.body.axes, scene.motion.omega_B, verticalOfL(scene));
}

Eigen::Vector3d startOmega_P(const Scene& scene) { return scene.body.axes.toP(scene.motion.omega_B); }

double chosenSpeed(const Scene& scene) { return scene.time.speed ? *scene.time.speed : automaticPace(scene); }

int spinAxis(const Eigen::Vector3d& omega_P) {
  int axis = 0;
  omega_P.cwiseAbs().maxCoeff(&axis);
  return axis;
}

// Enlarging the small omega perpendicular to the spin axis gives another exact motion of the same body. If that
// motion is of another kind, the picture would be false.
Eigen::Vector3d drawnOmega_P(const Scene& scene) {
  Eigen::Vector3d omega_P = startOmega_P(scene);
  if (scene.show.exaggerateAngles == 1) return omega_P;
  const physics::PrincipalMoments& moments = scene.body.axes.moments();
  Eigen::Vector3d drawn_P = exaggerated(omega_P, spinAxis(omega_P), scene.show.exaggerateAngles);
  const bool sameAxis = spinAxis(drawn_P) == spinAxis(omega_P);
  if (sameAxis && roundLargest(moments, drawn_P) == roundLargest(moments, omega_P)) return drawn_P;
  throw core::sceneError(
      "show.exaggerate_angles: with this factor the drawn motion would be of another kind; choose a smaller "
      "factor");
}

Eigen::Vector3d undrawnOmega_P(const Scene& scene, const Eigen::Vector3d& drawn_P) {
  if (scene.show.exaggerateAngles == 1) return drawn_P;
  const int axis = spinAxis(startOmega_P(scene));
  return exaggerated(drawn_P, axis, 1 / scene.show.exaggerateAngles);
}

std::optional<physics::FlightPath> flightPath(const Scene& scene, const physics::Motion& motion) {
  if (!scene.motion.flight) return std::nullopt;
  const double mass_kg = scene.body.mass ? scene.body.mass->mass_kg() : std::numeric_limits<double>::quiet_NaN();
  return physics::FlightPath(*scene.motion.flight, mass_kg, motion);
}

std::unique_ptr<const physics::Motion> makeMotion(const Scene& scene, double from_s, double to_s) {
  const Motion& motion = scene.motion;
  if (motion.rolling) return std::make_unique<physics::RollingMotion>(scene.body.axes, motion.rolling->cone);
  const physics::Quaternion q0_WB = startOrientation(scene);
  if (motion.forcing.none()) return std::make_unique<physics::FreeMotion>(scene.body.axes, motion.omega_B, q0_WB);
  try {
    return std::make_unique<physics::DrivenMotion>(scene.body.axes, motion.omega_B, q0_WB, motion.forcing,
                                                   physics::TimeSpan{from_s, to_s}, motion.tolerance_rad,
                                                   motion.mostSteps);
  } catch (const core::Error& error) {
    if (error.kind() != core::ErrorKind::kLimit) throw;
    throw core::Error(error.kind(), fmt::format("{}; {}", error.message(), howToRaise(Limit::kSteps)));
  }
}

}  // namespace poinsot::scene
