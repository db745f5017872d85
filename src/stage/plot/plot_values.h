// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stage/plot/plot_frame.h"

/// Names and values of quantities beside a plot's curves. They keep their positions during the film.
namespace poinsot::stage {

struct PlotValue {
  std::string tex;  ///< symbol of the quantity, in a formula
  draw::Color color{0};
  double value = 0;     ///< value at the cursor, in the axis's unit
  double endShare = 0;  ///< end of the curve, as a fraction of the axis
};

/// Number format for values on an axis. Values that are a pixel apart are written differently.
struct ValueFormat {
  int decimals = 0;
  double width_em = 0;  ///< width of the widest value on the axis
};

ValueFormat valueFormat(const PlotAxis& axis, scene::DecimalSign sign);

/// Returns the width of names and values. @param format  nullopt for names without values
double valuesWidth(const std::vector<PlotValue>& values, const std::optional<ValueFormat>& format,
                   const PlotPen& pen);

/// Adds names and values, each beside the end of its curve. They do not overlap, and their digits are aligned.
/// @param format  nullopt for names without values
void addValues(draw::Picture& picture, const PixelBox& panel, const PixelBox& area,
               const std::vector<PlotValue>& values, const std::optional<ValueFormat>& format, const PlotPen& pen);

/// Returns positions near the wanted positions, in the same order. Positions are at least `apart` from each other.
/// They are between `low` and `high` if there is room.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double low, double high);

}  // namespace poinsot::stage
