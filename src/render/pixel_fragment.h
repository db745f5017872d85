// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace poinsot::render {

/// Part of a triangle that lies in one pixel. Coordinates in the pixel range from 0 to 1, y down.
struct PixelFragment {
  double area = 0;  ///< exact area as a fraction of the pixel
  /// Perspective-correct weights of the triangle's vertices at the point `middle`
  glm::dvec3 weights{0};
  /// Distances along the view: the least, the greatest, and the distance at the point `middle`
  double near = 0, far = 0, depth = 0;
  /// Sides of the triangle as (a, b, c), with a x + b y + c >= 0 inside
  std::array<glm::dvec3, 3> edges;
  /// (a, b, c), with a x + b y + c = 1 / depth; with parallel rays a x + b y + c = -depth
  glm::dvec3 nearness{0};
  /// Bounds of the nearness (1 / depth or -depth) within the triangle
  double nearest = 0, farthest = 0;
  bool parallel = false;

  bool holds(glm::dvec2 p) const;
  double nearnessAt(glm::dvec2 p) const;
  double depthAt(glm::dvec2 p) const { return parallel ? -nearnessAt(p) : 1 / nearnessAt(p); }
  glm::dvec2 middle{0};
};

/// Clips a triangle to a pixel. Returns nullopt if the triangle does not reach the pixel.
/// @param triangle  corners: x and y in pixels, distance along the view. The triangle must face the eye.
/// @param parallel  whether the view has parallel rays
std::optional<PixelFragment> pixelFragment(const std::array<glm::dvec3, 3>& triangle, glm::ivec2 pixel,
                                           bool parallel = false);

/// Returns the visible area of each fragment, as a fraction of the pixel. Areas are exact if nothing is hidden;
/// otherwise they are estimated from samples. The sum is at most 1.
std::vector<double> visibleAreas(std::span<const PixelFragment> fragments);

}  // namespace poinsot::render
