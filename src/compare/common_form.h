// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::compare {

/// Converts two pictures to one storage format, without a visible change, so that values can be compared. If one
/// has 16 bits, both get 16. If one has alpha that is not opaque, both get alpha; otherwise, alpha is dropped.
/// Colours under alpha 0, which are invisible, become 0 0 0.
void toCommonForm(image::AnyImage& a, image::AnyImage& b);

/// Returns the picture blended onto a grey background, as RGB. Blends encoded values, as browsers do.
/// @pre four channels.
/// @param paper  background, from 0 (black) to kMost (white)
template <typename Sample>
image::BasicImage<Sample> onPaper(const image::BasicImage<Sample>& picture, Sample paper);

}  // namespace poinsot::compare
