// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"

namespace poinsot::scene {

enum class PlotTime { kMotion, kFilm };

/// Ends of an axis, in the unit written at the axis.
struct PlotRange {
  double low = 0, high = 1;
};

/// Panel with curves. Shows quantities as functions of time, or one quantity as a function of another (phase
/// portrait). Quantities are indices into stateQuantities().
struct Plot {
  std::vector<int> quantities;  ///< quantities along y, all with the same unit; only one in a phase portrait
  std::optional<int> x;         ///< quantity along x in a phase portrait; nullopt for time
  std::string title;            ///< title in the TeX subset of the text library
  std::string unit;             ///< unit of the quantities, such as "rpm"; empty for a unit that suits the numbers
  std::optional<PlotRange> range;  ///< range of the vertical axis; nullopt for a range that fits the film
  PlotTime time = PlotTime::kMotion;
  bool future = true;  ///< whether the curve after the current instant is drawn too, faintly
  bool cursor = true;  ///< whether the current instant is marked; if not, the whole curve counts as travelled
  GridPlace place;
};

}  // namespace poinsot::scene
