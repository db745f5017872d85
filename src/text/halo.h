// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace poinsot::text {

struct Point {
  double x = 0;
  double y = 0;

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(Point a, double s) { return {a.x * s, a.y * s}; }
};

inline double distance(Point a, Point b) {
  const Point d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

/// Grows filled shapes by a radius, from the distance of each pixel to the nearest piece of outline.
///
/// A distance is the radius with round corners by definition, and the least of several is their union. FreeType's
/// stroker was not taken: its offset curves cross themselves in the narrow places of letters (the eye of an e),
/// where filling them leaves holes or counts overlaps twice.
class HaloBuilder {
 public:
  /// Sizes and radius in pixels.
  HaloBuilder(int width, int height, double radius_px);

  /// A straight piece of outline, in pixels from the map's top left corner, y down.
  void addSegment(Point from, Point to);

  /// Turns the coverage of the shapes into that of the grown shapes.
  void growInto(std::vector<std::uint8_t>& values) const;

 private:
  int width_;
  int height_;
  double radius_px_;
  std::vector<double> distance2_;  // squared, from each pixel's centre; infinite where too far to matter
};

}  // namespace poinsot::text
