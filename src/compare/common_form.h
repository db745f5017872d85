// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::compare {

/// Converts two pictures to one storage format, so that their values can be compared. The conversion has no
/// visible effect. If one picture has 16 bits, both get 16 bits. If one picture is not fully opaque, both get
/// alpha; otherwise, alpha is dropped. Pixels with alpha 0, which are invisible, get the colour 0 0 0.
void toCommonForm(image::AnyImage& a, image::AnyImage& b);

/// Returns the picture blended onto a grey background, as RGB. Encoded (sRGB) values are blended, as in browsers.
/// @pre four channels.
/// @param paper  background, from 0 (black) to kMost (white)
template <typename Sample>
image::BasicImage<Sample> onPaper(const image::BasicImage<Sample>& picture, Sample paper);

}  // namespace poinsot::compare
