// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "stage/plot/plot_ticks.h"
#include "stage/quantity_track.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {

/// Axis of a plot. Lengths along the axis are in the unit that is written at it.
struct PlotAxis {
  WrittenUnit unit;
  double low = 0, high = 1;
  Ticks ticks;
  std::string label;

  /// Returns the place of an SI value on the axis: 0 at the low end, 1 at the high end.
  double share(double si) const { return shareOfWritten(unit.written(si)); }
  double shareOfWritten(double x) const { return (x - low) / (high - low); }
};

/// Returns an axis from tick to tick that holds a film's values. Values that vary only by rounding get an axis
/// from zero.
/// @param tex  symbols of the quantities, in a formula
/// @param asked  unit to write; empty: a suitable one
PlotAxis valueAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked);

/// Returns an axis from `low` to `high`, which are in the unit that valueAxis() chooses.
PlotAxis givenAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked, double low, double high);

/// Returns an axis between two times, in either order, s. The axis ends exactly where the film does.
PlotAxis timeAxis(double from_s, double to_s, const std::string& tex);

/// Returns the axis with at most `most` ticks; a `most` below 3 counts as 3.
PlotAxis withFewerTicks(const PlotAxis& axis, int most);

}  // namespace poinsot::stage
