// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"

namespace poinsot::figure {

/// Refits a picture without paper, which was mixed in linear light, for programs that lay one picture over
/// another, all of which mix encoded values: over `paper` it looks as drawn on it. Where it is not opaque, alpha
/// is what keeps the ink nearest to its colour, so that an edge has no fringe of the paper's, whatever the picture
/// is laid on. Pixels of alpha 0 become 0, 0, 0, 0: hidden colours would differ between formats, and optimisers of
/// PNG files clear them.
/// @pre four channels
template <typename Sample>
void fitAlpha(image::BasicImage<Sample>& picture, const draw::Color& paper);

}  // namespace poinsot::figure
