// SPDX-License-Identifier: Apache-2.0
#include "figure/named_points.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace poinsot::figure {
namespace {

// Largest distance from the picture's corner, in points of 1/72 inch: about 1 m. TeX cannot compute with lengths
// above 16383 pt.
constexpr double kFarthest_pt = 2835;

/// Returns the name, with the first free of the endings -2, -3, ... if the name is used already.
std::string freeName(const std::string& name, std::set<std::string>& used) {
  std::string free = name;
  for (int k = 2; !used.insert(free).second; ++k) free = fmt::format("{}-{}", name, k);
  return free;
}

std::vector<PlacedPoint> pointsOf(const draw::Panel& panel, double pointsPerPixel) {
  std::vector<PlacedPoint> placed;
  std::set<std::string> used;
  const draw::Camera& camera = panel.list.camera;
  for (const draw::NamedPoint& point : panel.list.points) {
    const std::string name =
        freeName(point.name, used);  // also of points that are left out, so names do not change
    if (!(depthOf(camera, point.at_V) >= camera.near)) continue;
    const glm::dvec2 at_px = glm::dvec2(panel.origin_px) + glm::dvec2(project(camera, point.at_V));
    const double reach_pt = pointsPerPixel * std::max(std::abs(at_px.x), std::abs(at_px.y));
    if (reach_pt <= kFarthest_pt) placed.push_back({name, at_px});
  }
  return placed;
}

}  // namespace

std::vector<PlacedPoint> placedPoints(const draw::Picture& picture, double pointsPerPixel) {
  std::vector<PlacedPoint> all;
  const std::size_t panels = picture.panels.size();
  for (std::size_t i = 0; i < panels; ++i) {
    const std::vector<PlacedPoint> points = pointsOf(picture.panels[i], pointsPerPixel);
    for (const PlacedPoint& point : points)
      if (i == 0) all.push_back({"poinsot-" + point.name, point.at_px});
    for (const PlacedPoint& point : points)
      if (panels > 1) all.push_back({fmt::format("poinsot-{}-{}", i + 1, point.name), point.at_px});
  }
  return all;
}

}  // namespace poinsot::figure
