// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace poinsot::stage {

/// Sample of a curve. x and y are fractions of the axes' lengths, from the point where the axes meet. x or y is
/// not finite if the quantity is undefined at this time.
struct PlotPoint {
  double filmTime_s = 0;
  double x = 0, y = 0;
};

using PlotPath = std::vector<std::vector<PlotPoint>>;

PlotPath finiteStretches(std::span<const PlotPoint> points);

/// Returns at most four points of a curve for each of `columns` columns of equal width: the first, lowest, highest
/// and last point, in the order of the curve. A band of fast oscillations therefore keeps its full height.
/// @pre x only increases or only decreases.
std::vector<PlotPoint> perColumn(std::span<const PlotPoint> points, int columns);

/// Returns the curve without the points that are within `tolerance` of the simplified curve (Douglas and Peucker
/// 1973).
std::vector<PlotPoint> simplified(std::span<const PlotPoint> points, double tolerance);

/// Returns the parts of the curve with 0 <= y <= 1.
PlotPath insideBand(std::span<const PlotPoint> points);

/// Return the part of a curve before or after the film time of `cursor`. Both parts contain `cursor`.
std::vector<PlotPoint> before(std::span<const PlotPoint> points, const PlotPoint& cursor);
std::vector<PlotPoint> after(std::span<const PlotPoint> points, const PlotPoint& cursor);

}  // namespace poinsot::stage
