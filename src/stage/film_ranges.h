// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stage/plot/plot_figure.h"
#include "stage/quantity_track.h"

namespace poinsot::stage {

/// What a scene's plots and read-outs go through in its film, in the order of the scene. Those of films that are
/// to be compared are joined: the axes are the same then, and the digits.
struct FilmRanges {
  std::vector<PlotRanges> plots;
  std::vector<QuantityRange> readouts;
};

}  // namespace poinsot::stage
