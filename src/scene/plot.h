// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"

namespace poinsot::scene {

enum class PlotTime { kMotion, kFilm };

/// Ends of an axis, in the unit that is written at the axis.
struct PlotRange {
  double low = 0, high = 1;
};

/// Panel with curves: quantities against time, or one quantity against another (phase portrait). Quantities are
/// indices into stateQuantities().
struct Plot {
  std::vector<int> quantities;     ///< all of one unit; in a phase portrait only one, along y
  std::optional<int> x;            ///< quantity along x of a phase portrait; nullopt: time
  std::string title;               ///< in the TeX subset of the text library
  std::string unit;                ///< of the quantities, such as "rpm"; empty: chosen to suit the numbers
  std::optional<PlotRange> range;  ///< range of the vertical axis; nullopt: chosen to fit the film
  PlotTime time = PlotTime::kMotion;
  bool future = true;  ///< also draws the part not yet travelled, faintly
  GridPlace place;
};

}  // namespace poinsot::scene
