// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/construction.h"

#include <algorithm>
#include <cmath>

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kPlaneBeyondEllipsoid = 1.18;  // smallest half width, relative to the longest semi-axis
// Smallest half width of the plane, relative to the largest distance of a contact point from the plane's centre.
constexpr double kPlaneBeyondPath = 1.2;
constexpr double kCellsToEdge = 7;  // approximate number of grid cells from the centre to the edge

double niceNumber(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0})
    if (x <= 1.42 * step * power) return step * power;
  return 10 * power;
}

// Returns a fixed horizontal direction that is not along L. The grid follows this direction, so that it does not
// rotate while L moves.
Vector3d gridHint(const Vector3d& L_W) {
  return std::abs(L_W.normalized().x()) < 0.9 ? Vector3d(1, 0, 0) : Vector3d(0, 1, 0);
}

double farthestContact(const PictureMotion& motion) {
  double radius = 0;
  for (const PathPoint& p : motion.outline())
    if (p.L_W.norm() > 0) radius = std::max(radius, p.L_W.normalized().cross(p.omega_W).norm());
  return radius;
}

}  // namespace

Construction::Construction(const PictureMotion& motion, const Scales& scales)
    : moments_(motion.moments()),
      scale_(scales.ellipsoid),
      semiAxes_(scale_ * physics::PoinsotConstruction(moments_, motion.liveliest().omega_P).semiAxes_P()),
      gridHint_W_(gridHint(motion.liveliest().L_W)) {
  const double wanted =
      std::max(kPlaneBeyondEllipsoid * semiAxes_.maxCoeff() / scale_, kPlaneBeyondPath * farthestContact(motion));
  spacing_ = niceNumber(wanted / kCellsToEdge);
  halfWidth_ = std::ceil(wanted / spacing_ - 1e-9) * spacing_ * scale_;
}

Eigen::Matrix3d Construction::semiAxes_V(const PictureState& state) const {
  const physics::PoinsotConstruction now(moments_, state.omega_P);
  return state.R_VP * (scale_ * now.semiAxes_P()).asDiagonal();
}

double Construction::planeHeight(const PictureState& state) const {
  return scale_ * physics::PoinsotConstruction(moments_, state.omega_P).planeHeight();
}

// The plane is fixed in inertial space. In views in which the body is fixed, the grid therefore rotates with the
// axes W.
Eigen::Matrix<double, 3, 2> Construction::planeHalfEdges_V(const PictureState& state) const {
  const Vector3d normal_W = state.L_W.normalized();
  const Vector3d u_W = (gridHint_W_ - gridHint_W_.dot(normal_W) * normal_W).normalized();
  Eigen::Matrix<double, 3, 2> edges;
  edges.col(0) = halfWidth_ * (state.R_VW * u_W);
  edges.col(1) = halfWidth_ * (state.R_VW * normal_W.cross(u_W));
  return edges;
}

std::array<Vector3d, 4> Construction::planeCorners_V(const PictureState& state) const {
  const Vector3d centre = planeHeight(state) * state.L_V.normalized();
  const Eigen::Matrix<double, 3, 2> edges = planeHalfEdges_V(state);
  const auto corner = [&](double a, double b) { return Vector3d(centre + a * edges.col(0) + b * edges.col(1)); };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

}  // namespace poinsot::stage
