// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace poinsot::render {

/// Part of a triangle that lies in one pixel, in the pixel's own coordinates (0 to 1, y down).
struct PixelFragment {
  double area = 0;                      ///< exact share of the pixel
  glm::dvec3 weights{0};                ///< perspective-correct weights of the triangle's vertices at `middle`
  double near = 0, far = 0, depth = 0;  ///< distances along the view: least, greatest, at `middle`
  std::array<glm::dvec3, 3> edges;      ///< each is (a, b, c) with a x + b y + c >= 0 inside the triangle
  glm::dvec3 nearness{0};  ///< (a, b, c): nearness = a x + b y + c is 1 / depth, or -depth if rays are parallel
  double nearest = 0, farthest = 0;  ///< bounds of the nearness over the triangle
  bool parallel = false;

  bool holds(glm::dvec2 p) const;
  double nearnessAt(glm::dvec2 p) const;
  double depthAt(glm::dvec2 p) const { return parallel ? -nearnessAt(p) : 1 / nearnessAt(p); }
  glm::dvec2 middle{0};
};

/// Clips a triangle to a pixel. Returns nullopt if the triangle does not reach the pixel.
/// @param triangle  x and y in pixels, distance along the view; must face the eye
/// @param parallel  whether rays are parallel
std::optional<PixelFragment> pixelFragment(const std::array<glm::dvec3, 3>& triangle, glm::ivec2 pixel,
                                           bool parallel = false);

/// Returns for each fragment the share of the pixel in which it is visible: exact areas where nothing is hidden,
/// otherwise estimates from samples. The sum is at most 1.
std::vector<double> visibleAreas(std::span<const PixelFragment> fragments);

}  // namespace poinsot::render
