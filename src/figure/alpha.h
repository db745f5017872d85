// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"

namespace poinsot::figure {

/// Converts a picture without paper, mixed in linear light, for programs that mix encoded values when they lay one
/// picture over another. Over `paper` the picture looks as if drawn on it. Translucent pixels get the alpha that
/// keeps the ink nearest to its colour, so that no edge has a fringe of the paper's colour on any background.
/// Pixels of alpha 0 become 0, 0, 0, 0: hidden colours would differ between formats, and optimisers of PNG files
/// clear them.
/// @pre four channels
template <typename Sample>
void fitAlpha(image::BasicImage<Sample>& picture, const draw::Color& paper);

}  // namespace poinsot::figure
