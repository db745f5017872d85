// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "stage/plot/plot_ticks.h"
#include "stage/quantity_track.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {

/// One axis of a plot. Lengths along it in the unit that is written at it.
struct PlotAxis {
  WrittenUnit unit;
  double low = 0, high = 1;
  Ticks ticks;
  std::string label;

  /// 0 at the low end, 1 at the high one.
  double share(double si) const { return shareOfWritten(unit.written(si)); }
  double shareOfWritten(double x) const { return (x - low) / (high - low); }
};

/// An axis from tick to tick that holds a film's values. One that does not vary but by rounding gets an axis from
/// zero. `tex`: of the quantities, in a formula; `asked`: the unit to write them in, empty for one that suits.
PlotAxis valueAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked);

/// An axis with ends of its own, in the unit that the values' axis would have.
PlotAxis givenAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked, double low, double high);

/// From one time to another, in either order, s. Ends where the film does.
PlotAxis timeAxis(double from_s, double to_s, const std::string& tex);

/// So many ticks at most.
PlotAxis withFewerTicks(const PlotAxis& axis, int most);

}  // namespace poinsot::stage
