// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "stage/plot/plot_frame.h"

/// Names and values beside a plot's curves, which keep their places during the film.
namespace poinsot::stage {

struct PlotValue {
  std::string tex;  ///< symbol of the quantity, in a formula
  draw::Color color{0};
  double value = 0;     ///< value at the cursor, in the axis's unit
  double endShare = 0;  ///< end of the curve, as a share of the axis
};

/// Format of an axis's values, with enough decimals to distinguish pixels.
struct ValueFormat {
  int decimals = 0;
  double width_em = 0;  ///< width of the widest value on the axis
};

ValueFormat valueFormat(const PlotAxis& axis, scene::DecimalSign sign);

double valuesWidth(const std::vector<PlotValue>& values, const ValueFormat& format, const PlotPen& pen);

/// Adds names and values, each beside its curve's end, apart from one another, with digits aligned.
void addValues(draw::Picture& picture, const PixelBox& panel, const PixelBox& area,
               const std::vector<PlotValue>& values, const ValueFormat& format, const PlotPen& pen);

/// Returns places near the wanted ones and in their order, at least `apart` from each other and, if there is room,
/// between `low` and `high`.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double low, double high);

}  // namespace poinsot::stage
