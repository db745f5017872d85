// SPDX-License-Identifier: Apache-2.0
#include "stage/scales.h"

#include <algorithm>
#include <cmath>

#include "physics/poinsot_construction.h"

namespace poinsot::stage {
namespace {

constexpr double kBodyInEllipsoid =
    0.62;                             // of the ellipsoid, along the direction where the body comes nearest to it
constexpr double kBodyAlone = 0.8;    // longest half extent where no ellipsoid is shown
constexpr double kOmegaAlone = 1.25;  // longest omega where no ellipsoid is shown
constexpr double kLAbove = 1.5, kLBelowPlane = 0.42;

double longestOmega(const PictureMotion& motion) {
  double longest = 0;
  for (const PathPoint& p : motion.outline()) longest = std::max(longest, p.omega_P.norm());
  return longest;
}

}  // namespace

Scales makeScales(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body) {
  Scales scales;
  const auto& show = scene.show;
  const bool construction = show.ellipsoid.visible || show.plane.visible;
  const double omega = longestOmega(motion);
  if (construction && omega > 0) {
    const physics::PoinsotConstruction construct(motion.moments(), motion.pathPoint(0).omega_P);
    const Eigen::Vector3d semiAxes = construct.semiAxes_P();
    scales.ellipsoid = show.ellipsoid.scale / semiAxes.maxCoeff();
    const Eigen::Vector3d shown = scales.ellipsoid * semiAxes;
    scales.body = kBodyInEllipsoid * show.body.scale / body.reachIn(shown);
    const double height = construct.planeHeight() * scales.ellipsoid;
    scales.lengthOfL = show.L.scale * (show.plane.visible ? height + kLBelowPlane : kLAbove);
    scales.reach = std::max(shown.maxCoeff(), scales.body * body.radius());
  } else {
    scales.body = kBodyAlone * show.body.scale / body.reachAlongAxes().maxCoeff();
    scales.ellipsoid = omega > 0 ? kOmegaAlone / omega : 1;
    scales.lengthOfL = kLAbove * show.L.scale;
    scales.reach = scales.body * body.radius();
  }
  scales.omega = scales.ellipsoid * show.omega.scale;
  return scales;
}

}  // namespace poinsot::stage
