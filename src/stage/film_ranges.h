// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stage/plot/plot_figure.h"
#include "stage/quantity_track.h"

namespace poinsot::stage {

/// Value ranges of a scene's plots and read-outs over its film, in the order of the scene. Films that are shown
/// side by side use joined ranges, so that their axes and their numbers of digits agree.
struct FilmRanges {
  std::vector<PlotRanges> plots;
  std::vector<QuantityRange> readouts;
};

}  // namespace poinsot::stage
