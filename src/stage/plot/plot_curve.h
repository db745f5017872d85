// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace poinsot::stage {

/// A sample of a curve: where it is, in shares of the axes' lengths from their crossing, and when. Not finite
/// where the quantity does not exist.
struct PlotPoint {
  double filmTime_s = 0;
  double x = 0, y = 0;
};

/// A curve's finite stretches.
using PlotPath = std::vector<std::vector<PlotPoint>>;

PlotPath finiteStretches(std::span<const PlotPoint> points);

/// Of the points in each of `columns` equal columns the first, the lowest, the highest and the last, in their
/// order: a band of fast wobbles keeps its full height however many lie in a column. @pre x runs one way.
std::vector<PlotPoint> perColumn(std::span<const PlotPoint> points, int columns);

/// The curve without the points that lie within `tolerance` of the lines that remain (Douglas and Peucker 1973).
std::vector<PlotPoint> simplified(std::span<const PlotPoint> points, double tolerance);

/// What lies at 0 <= y <= 1.
PlotPath insideBand(std::span<const PlotPoint> points);

/// The part up to a film time, or from it on; `cursor` is the point there, which both have.
std::vector<PlotPoint> before(std::span<const PlotPoint> points, const PlotPoint& cursor);
std::vector<PlotPoint> after(std::span<const PlotPoint> points, const PlotPoint& cursor);

}  // namespace poinsot::stage
