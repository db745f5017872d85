// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"

namespace poinsot::output {

/// Refits the alpha of a picture without paper, which was mixed in linear light, for programs that lay one picture
/// over another, all of which mix encoded values: over `paper` it looks as drawn on it. Colours stay as they are,
/// so that an edge has no fringe of the paper's colour, whatever the picture is laid on.
/// @pre four channels
void fitAlpha(image::Image& picture, const draw::Color& paper);

}  // namespace poinsot::output
