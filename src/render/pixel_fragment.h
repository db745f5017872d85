// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace poinsot::render {

/// The part of a triangle that lies in one pixel, in the pixel's own coordinates (0 to 1, y down).
struct PixelFragment {
  double area = 0;        ///< exact, of the pixel
  glm::dvec3 weights{0};  ///< of the triangle's vertices at the middle of the part, right for the rays
  double near = 0, far = 0, depth = 0;  ///< least, greatest, at the middle; distance along the view
  std::array<glm::dvec3, 3> edges;      ///< (a, b, c): a x + b y + c >= 0 inside the triangle
  glm::dvec3 nearness{0};               ///< nearness = a x + b y + c: 1 / depth, or -depth where rays are parallel
  double nearest = 0, farthest = 0;     ///< bounds of the nearness over the triangle
  bool parallel = false;                ///< rays

  bool holds(glm::dvec2 p) const;
  double nearnessAt(glm::dvec2 p) const;
  double depthAt(glm::dvec2 p) const { return parallel ? -nearnessAt(p) : 1 / nearnessAt(p); }
  glm::dvec2 middle{0};
};

/// @param triangle  x and y in pixels, distance along the view; it looks at the eye.
/// @param parallel  whether rays are
/// @return nothing when the triangle does not reach the pixel.
std::optional<PixelFragment> pixelFragment(const std::array<glm::dvec3, 3>& triangle, glm::ivec2 pixel,
                                           bool parallel = false);

/// Which share of the pixel each fragment is seen in: exact areas where nothing is hidden, else by samples.
/// @return one number to a fragment; their sum is at most 1.
std::vector<double> visibleAreas(std::span<const PixelFragment> fragments);

}  // namespace poinsot::render
