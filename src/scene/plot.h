// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"

namespace poinsot::scene {

/// Which time a plot's axis counts.
enum class PlotTime { kMotion, kFilm };

/// Both in the unit that is written at the axis.
struct PlotRange {
  double low = 0, high = 1;
};

/// A panel with curves: quantities against time, or one quantity against another (phase portrait). Quantities are
/// indices into stateQuantities().
struct Plot {
  std::vector<int> quantities;     ///< of one unit; one for a phase portrait: its y
  std::optional<int> x;            ///< of a phase portrait; none: time
  std::string title;               ///< the TeX subset of text/
  std::string unit;                ///< "rpm", of the quantities; empty: one that suits the numbers
  std::optional<PlotRange> range;  ///< of the vertical axis; none: what the film needs
  PlotTime time = PlotTime::kMotion;
  bool future = true;  ///< the part not yet travelled is drawn too, faint
  GridPlace place;
};

}  // namespace poinsot::scene
