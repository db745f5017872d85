// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "draw/picture.h"

namespace poinsot::draw {

/// Returns the width of the thinnest visible line of a picture, in pixels; nullopt if the picture has no lines.
/// Lines are flat curves, strokes, graticules, grids, the outlines of sheets and cones, and the edges and markings
/// of solids. Tubes and arrows are solids.
std::optional<float> thinnestLine_px(const Picture& picture);

}  // namespace poinsot::draw
