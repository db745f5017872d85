// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/globe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr int kRimPoints = 360;

/// Returns the point on the rim between a visible and a hidden point of a curve.
Vector3d onRim(const Vector3d& a, const Vector3d& b) {
  const Vector3d between = a + (b - a) * (a.z() / (a.z() - b.z()));
  return Vector3d(between.x(), between.y(), 0).normalized();
}

double angleOf(const Vector3d& onRim) { return std::atan2(onRim.y(), onRim.x()); }

}  // namespace

Globe::Globe(const Vector3d& eye, const Vector3d& up, glm::dvec2 centre_px, double radius_px)
    : centre_px_(centre_px), radius_px_(radius_px) {
  const Vector3d right = up.cross(eye).normalized();
  axes_ << right, eye.normalized().cross(right), eye.normalized();
}

glm::vec2 Globe::placed_px(const Eigen::Vector2d& right_up) const {
  return {centre_px_.x + radius_px_ * right_up.x(), centre_px_.y - radius_px_ * right_up.y()};
}

glm::vec2 Globe::at_px(const Vector3d& direction, double radii) const {
  return placed_px(radii * seen(direction).head<2>());
}

Globe::Line_px Globe::rim() const {
  Line_px rim;
  for (int i = 0; i < kRimPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRimPoints;
    rim.push_back(placed_px({std::cos(angle), std::sin(angle)}));
  }
  return rim;
}

std::vector<Globe::Directions> Globe::visibleRuns(const Directions& curve) const {
  Directions points;
  for (const Vector3d& direction : curve) points.push_back(seen(direction));
  const std::size_t n = points.size();
  std::size_t hidden = 0;
  while (hidden < n && points[hidden].z() >= 0) ++hidden;
  if (hidden == n) return {points};
  std::vector<Directions> runs;
  for (std::size_t i = 1; i <= n; ++i) {
    const Vector3d &before = points[(hidden + i - 1) % n], &point = points[(hidden + i) % n];
    const bool was = before.z() >= 0, is = point.z() >= 0;
    if (is && !was) runs.push_back({onRim(before, point)});
    if (is) runs.back().push_back(point);
    if (was && !is) runs.back().push_back(onRim(before, point));
  }
  return runs;
}

std::vector<Globe::Line_px> Globe::visibleParts(const Directions& curve, double inset_px) const {
  const double most = std::max(0.0, 1 - inset_px / radius_px_);
  const auto placed = [&](const Vector3d& point) {
    const double r = point.head<2>().norm();
    return placed_px(point.head<2>() * (r > most ? most / r : 1));
  };
  std::vector<Line_px> lines;
  for (const Directions& run : visibleRuns(curve)) {
    Line_px& line = lines.emplace_back();
    for (const Vector3d& point : run) line.push_back(placed(point));
    if (run.size() == curve.size()) line.push_back(line.front());
  }
  return lines;
}

Globe::Line_px Globe::visiblePart(const Directions& curve,
                                  const std::function<bool(const Vector3d&)>& inside) const {
  const std::vector<Directions> runs = visibleRuns(curve);
  if (runs.empty()) return {};
  Line_px polygon;
  for (const Vector3d& point : runs.front()) polygon.push_back(placed_px(point.head<2>()));
  const Vector3d &first = runs.front().front(), &last = runs.front().back();
  if (first.z() == 0 && last.z() == 0) addRim(polygon, last, first, inside);
  return polygon;
}

// Adds the arc of the rim that joins two points inside the region.
void Globe::addRim(Line_px& polygon, const Vector3d& from, const Vector3d& to,
                   const std::function<bool(const Vector3d&)>& inside) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double begin = angleOf(from);
  double sweep = angleOf(to) - begin;
  const double half = begin + 0.5 * sweep;
  if (!inside(axes_ * Vector3d(std::cos(half), std::sin(half), 0))) sweep += sweep > 0 ? -kTurn : kTurn;
  const int steps = static_cast<int>(std::ceil(std::abs(sweep) / kTurn * kRimPoints));
  for (int i = 1; i < steps; ++i) {
    const double angle = begin + sweep * i / steps;
    polygon.push_back(placed_px({std::cos(angle), std::sin(angle)}));
  }
}

}  // namespace poinsot::stage
