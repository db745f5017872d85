// SPDX-License-Identifier: Apache-2.0
#include "stage/scales.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <variant>

#include "physics/poinsot_construction.h"

namespace poinsot::stage {
namespace {

// Size of the body relative to the ellipsoid, in the direction where the two come nearest to each other.
constexpr double kBodyInEllipsoid = 0.62;
constexpr double kBodyAlone = 0.8;     // half the longest extent of the body, if no ellipsoid is shown
constexpr double kRadiusAlone = 1.05;  // largest radius of the body, if no ellipsoid is shown
constexpr double kOmegaAlone = 1.25;   // drawn length of the largest omega, if no ellipsoid is shown
constexpr double kVelocity = 0.7;      // drawn length of the largest velocity
constexpr double kLongestPath = 9;     // longest drawn path of a flight, as a multiple of Scales::reach
constexpr double kLAbove = 1.5, kLBelowPlane = 0.42;

// Largest magnitudes of omega (rad/s) and L (kg·m²/s) in the film.
struct Longest {
  double omega = 0, L = 0;
  explicit Longest(const PictureMotion& motion) {
    for (const PathPoint& p : motion.outline()) {
      omega = std::max(omega, p.omega_P.norm());
      L = std::max(L, p.L_W.norm());
    }
  }
};

// Returns the largest speed in the film, m/s, of the point whose V is drawn and of all other points whose velocity
// is drawn.
double fastestShown(const scene::Scene& scene, const PictureMotion& motion) {
  double fastest = 0;
  for (const PathPoint& p : motion.outline()) {
    const PictureState state = motion.atPlayed(p.played_s);
    fastest = std::max(fastest, state.velocityAt(scene::referencePoint_B(scene)).norm());
    for (const scene::NamedVector& vector : scene.vectors)
      if (const auto* of = std::get_if<scene::VelocityVector>(&vector.what))
        fastest = std::max(fastest, state.velocityAt(of->point_B - scene.body.fixedPoint_B()).norm());
  }
  return fastest;
}

// Returns the diagonal of the box around the path of the centre of mass, m; 0 if the centre of mass is fixed.
double pathExtent(const PictureMotion& motion) {
  Eigen::AlignedBox3d box;
  for (const PathPoint& p : motion.outline()) box.extend(motion.atPlayed(p.played_s).centre_V);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

Scales makeScales(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body) {
  Scales scales;
  const auto& show = scene.show;
  const bool construction = show.ellipsoid.visible || show.plane.visible;
  const Longest longest(motion);
  double lengthOfL = kLAbove;
  if (construction && longest.omega > 0) {
    const physics::PoinsotConstruction construct(motion.moments(), motion.liveliest().omega_P);
    const Eigen::Vector3d& semiAxes = construct.semiAxes_P();
    scales.ellipsoid = show.ellipsoid.scale / semiAxes.maxCoeff();
    const Eigen::Vector3d shown = scales.ellipsoid * semiAxes;
    scales.body = kBodyInEllipsoid * show.body.scale / body.reachIn(shown);
    const double height = construct.planeHeight() * scales.ellipsoid;
    if (show.plane.visible) lengthOfL = height + kLBelowPlane;
    scales.reach = std::max(shown.maxCoeff(), scales.body * body.radius());
  } else {
    scales.body =
        show.body.scale * std::min(kBodyAlone / body.halfExtents().maxCoeff(), kRadiusAlone / body.radius());
    scales.ellipsoid = longest.omega > 0 ? kOmegaAlone / longest.omega : 1;
    scales.reach = scales.body * body.radius();
  }
  scales.flight = scales.body;
  if (const auto& wanted = show.figures.flight.scale)
    scales.flight *= *wanted;
  else if (const double path = scales.body * pathExtent(motion);
           path > kLongestPath * scales.reach && !scene.camera.follow)
    scales.flight *= kLongestPath * scales.reach / path;
  if (const double fastest = fastestShown(scene, motion); fastest > 0) scales.velocity = kVelocity / fastest;
  scales.omega = scales.ellipsoid * show.omega.scale;
  if (longest.L > 0) scales.L = show.L.scale * lengthOfL / longest.L;
  return scales;
}

}  // namespace poinsot::stage
