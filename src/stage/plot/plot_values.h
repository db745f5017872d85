// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "stage/plot/plot_frame.h"

/// What a plot writes beside its curves: names and values that keep their place while the film runs.
namespace poinsot::stage {

/// One curve's name and value.
struct PlotValue {
  std::string tex;  ///< of the quantity, in a formula
  draw::Color color{0};
  double value = 0;     ///< in the axis's unit, at the cursor
  double endShare = 0;  ///< where the curve ends: share of the axis
};

/// How values of an axis are written: with as many decimals as tell pixels apart.
struct ValueFormat {
  int decimals = 0;
  double width_em = 0;  ///< of the widest value on the axis
};

ValueFormat valueFormat(const PlotAxis& axis, scene::DecimalSign sign);

/// Room to the right of the curves for names and values, px.
double valuesWidth(const std::vector<PlotValue>& values, const ValueFormat& format, const PlotPen& pen);

/// Each beside its curve's end, apart from one another, digits under digits.
void addValues(draw::Picture& picture, const PixelBox& panel, const PixelBox& area,
               const std::vector<PlotValue>& values, const ValueFormat& format, const PlotPen& pen);

/// Places at least `apart` from each other and, where there is room, between `low` and `high`, near the wanted
/// ones and in their order.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double low, double high);

}  // namespace poinsot::stage
