// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::compare {

/// Brings two pictures into one form of storage without changing what they show, so that they can be compared by
/// value: 8 bits become the 16 that they stand for where the other has 16; pictures without alpha become opaque
/// where the other has some that is not; alpha that is opaque in both is left out; and what stands under alpha 0,
/// which nobody sees, becomes 0 0 0.
void toCommonForm(image::AnyImage& a, image::AnyImage& b);

/// The picture upon paper of one grey, as RGB; blended in encoded values, as browsers do.
/// @pre four channels.
/// @param paper  0 black, kMost white.
template <typename Sample>
image::BasicImage<Sample> onPaper(const image::BasicImage<Sample>& picture, Sample paper);

}  // namespace poinsot::compare
