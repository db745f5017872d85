// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/color.h"
#include "image/image.h"

namespace poinsot::figure {

/// Converts a picture with transparent background from mixing in linear light to mixing of encoded values, which
/// most programs use to draw one picture over another. Drawn over `paper`, the result looks like the original.
///
/// Translucent pixels get the alpha with which their ink changes least. Edges therefore have no fringe in the
/// colour of the paper on any background. Pixels of alpha 0 become 0, 0, 0, 0, because PNG optimisers clear hidden
/// colours and formats would differ in them.
/// @pre four channels
template <typename Sample>
void fitAlpha(image::BasicImage<Sample>& picture, const draw::Color& paper);

}  // namespace poinsot::figure
