// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/actor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stage/figures/arrow.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kDash = 0.035;  // length of dashes and gaps, in picture lengths
constexpr float kSoft = 0.6f;    // distance below which a direction is shortened, as a fraction of the text size

bool beforeEye(const draw::Camera& camera, glm::vec3 point) { return depthOf(camera, point) >= camera.near; }

/// Returns the distance by which a point can be moved towards the eye and is still drawn.
double mostLift(const draw::Camera& camera, const Vector3d& point_V) {
  constexpr double kWithin = 0.98;
  return kWithin * std::max(static_cast<double>(depthOf(camera, toPicture(point_V)) - camera.near), 0.0);
}

}  // namespace

void Canvas::line(const std::vector<Vector3d>& points_V, bool closed, const draw::Color& color, double width,
                  double lift) const {
  if (points_V.size() < 2) return;
  draw::Curve curve;
  for (const Vector3d& p : points_V) curve.points_V.push_back(toPicture(p));
  curve.closed = closed;
  curve.width_px = static_cast<float>(width * line_px);
  curve.lift_V = static_cast<float>(lift);
  curve.material.color = color;
  list.curves.push_back(std::move(curve));
}

void Canvas::dashes(const Vector3d& from_V, const Vector3d& to_V, const draw::Color& color, double width,
                    double lift) const {
  const double length = (to_V - from_V).norm();
  const int pieces =
      2 * static_cast<int>(std::round(0.5 * (length / kDash - 1))) + 1;  // an odd number, to end with a dash
  for (int i = 0; i < pieces; i += 2) {
    const Vector3d begin = from_V + (to_V - from_V) * i / pieces,
                   end = from_V + (to_V - from_V) * (i + 1) / pieces;
    line({begin, end}, false, color, width,
         std::min({lift, mostLift(list.camera, begin), mostLift(list.camera, end)}));
  }
}

void Canvas::arrow(const Vector3d& tip_V, double radius, const draw::Color& color) const {
  arrowFrom(Vector3d::Zero(), tip_V, radius, color);
}

void Canvas::arrowFrom(const Vector3d& from_V, const Vector3d& tip_V, double radius,
                       const draw::Color& color) const {
  addArrow(list, from_V, tip_V, radius * thickness, color);
}

void Canvas::dot(const Vector3d& at_V, double radius, const draw::Color& color) const {
  list.ellipsoids.push_back({toPicture(at_V), glm::mat3(static_cast<float>(radius)), {color, 0.4f}});
}

void Canvas::tube(const std::vector<Vector3d>& points_V, bool closed, double radius,
                  const draw::Color& color) const {
  if (points_V.size() < 2) return;
  draw::Curve curve;
  for (const Vector3d& p : points_V) curve.points_V.push_back(toPicture(p));
  curve.closed = closed;
  curve.radius_V = static_cast<float>(radius * thickness);
  curve.material.color = color;
  list.curves.push_back(std::move(curve));
}

draw::GlassEllipsoid& Canvas::glassEllipsoid(const Eigen::Matrix3d& semiAxes_V, const draw::Color& color,
                                             double opacity, const GlassShares& shares) const {
  draw::GlassEllipsoid& ellipsoid = list.glassEllipsoids.emplace_back();
  ellipsoid.semiAxes_V = toPicture(semiAxes_V);
  ellipsoid.color = color;
  ellipsoid.nearOpacity = glass(opacity, shares.near);
  ellipsoid.farOpacity = glass(opacity, shares.far);
  ellipsoid.rimOpacity = glass(opacity, shares.rim);
  return ellipsoid;
}

// The transmitted light is an exponential function of the thickness.
float Canvas::glass(double opacity, double share) const {
  return static_cast<float>(1 - std::pow(1 - opacity, share * colors.sheetOpacity));
}

void Canvas::label(const std::string& tex, const Vector3d& at_V, const Vector3d& inside_V,
                   const draw::Color& color, double size) const {
  if (!beforeEye(list.camera, toPicture(at_V))) return;
  labelAt(tex, at_px(at_V), softUnit(at_px(at_V) - at_px(inside_V), kSoft * static_cast<float>(type_px)), color,
          size);
}

void Canvas::labelAt(const std::string& tex, glm::vec2 at_px, glm::vec2 direction, const draw::Color& color,
                     double size, double gap, float opacity) const {
  if (type_px == 0 || tex.empty() || (still && opacity < 0.5f)) return;
  const auto size_px = static_cast<float>(std::max(size * type_px, least_px));
  labels.push_back(
      {tex, at_px, direction, static_cast<float>(gap) * size_px, size_px, color, still ? 1 : opacity});
}

void Canvas::point(std::string name, const Vector3d& at_V) const {
  list.points.push_back({std::move(name), toPicture(at_V)});
}

glm::vec2 Canvas::at_px(const Vector3d& at_V) const {
  const draw::Camera& camera = list.camera;
  const glm::vec3 point = toPicture(at_V);
  const float behind = beforeEye(camera, point) ? 0 : camera.near - depthOf(camera, point);
  return project(camera, point - behind * camera.R_VC[2]);
}

draw::Color mixed(const draw::Color& color, const draw::Color& over, double share) {
  const auto s = static_cast<float>(share);
  return s * color + (1 - s) * over;
}

std::vector<Vector3d> circleAbout(const Vector3d& centre_V, const Vector3d& axis_V, double radius, int points) {
  const Vector3d u = across(axis_V, Vector3d::UnitX()), v = axis_V.cross(u);
  std::vector<Vector3d> circle;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    circle.push_back(centre_V + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return circle;
}

Vector3d across(const Vector3d& axis, const Vector3d& hint) {
  const Vector3d part = hint - hint.dot(axis) * axis;
  if (part.norm() > 0.1) return part.normalized();
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return across(axis, Vector3d::Unit(least));
}

}  // namespace poinsot::stage
