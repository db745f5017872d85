// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace poinsot::stage {

/// Sample of a curve: its film time, and its place in shares of the axes' lengths from their crossing. The place
/// is not finite if the quantity does not exist.
struct PlotPoint {
  double filmTime_s = 0;
  double x = 0, y = 0;
};

using PlotPath = std::vector<std::vector<PlotPoint>>;

PlotPath finiteStretches(std::span<const PlotPoint> points);

/// Returns, of the points in each of `columns` equal columns, the first, the lowest, the highest and the last, in
/// their order. A band of fast oscillations thus keeps its full height. @pre x runs one way.
std::vector<PlotPoint> perColumn(std::span<const PlotPoint> points, int columns);

/// Returns the curve without the points that lie within `tolerance` of the remaining lines (Douglas and Peucker
/// 1973).
std::vector<PlotPoint> simplified(std::span<const PlotPoint> points, double tolerance);

/// Returns the parts of the curve at 0 <= y <= 1.
PlotPath insideBand(std::span<const PlotPoint> points);

/// Return the part up to a film time, or from that time on. Both contain `cursor`, the point at that time.
std::vector<PlotPoint> before(std::span<const PlotPoint> points, const PlotPoint& cursor);
std::vector<PlotPoint> after(std::span<const PlotPoint> points, const PlotPoint& cursor);

}  // namespace poinsot::stage
