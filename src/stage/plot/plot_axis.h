// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "stage/plot/plot_ticks.h"
#include "stage/quantity_track.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {

/// Axis of a plot. `low`, `high` and the ticks are in the unit of the axis.
struct PlotAxis {
  WrittenUnit unit;
  double low = 0, high = 1;
  Ticks ticks;
  std::string label;

  /// Returns the position of an SI value on the axis: 0 at the low end, 1 at the high end.
  double share(double si) const { return shareOfWritten(unit.written(si)); }
  double shareOfWritten(double x) const { return (x - low) / (high - low); }
};

/// Returns an axis that covers all values of a film. Both ends of the axis are ticks. If the values vary only by
/// rounding errors, the axis includes zero.
/// @param tex  symbols of the quantities, as TeX inside a formula
/// @param asked  unit of the axis; empty: a suitable unit is chosen
PlotAxis valueAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked);

/// Returns an axis from `low` to `high`, which are in the unit that valueAxis() chooses.
PlotAxis givenAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked, double low, double high);

/// Returns an axis from the earlier to the later of two times, s. The axis ends exactly at these times, even if
/// they are not ticks.
PlotAxis timeAxis(double from_s, double to_s, const std::string& tex);

/// Returns the axis with at most `most` ticks; a `most` below 3 counts as 3.
PlotAxis withFewerTicks(const PlotAxis& axis, int most);

}  // namespace poinsot::stage
