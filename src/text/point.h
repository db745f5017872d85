// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace poinsot::text {

/// Point in pixels (x right, y down) or in a font's units (x right, y up).
struct Point {
  double x = 0;
  double y = 0;

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(Point a, double s) { return {a.x * s, a.y * s}; }
};

inline double distance(Point a, Point b) {
  const Point d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y);  // IEEE 754 defines every bit of sqrt, as of + - * /
}

}  // namespace poinsot::text
