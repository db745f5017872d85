// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

namespace poinsot::image {

/// Returns the smallest rectangle with all pixels that are not fully transparent; empty if there are none.
/// @pre 4 channels.
PixelRect inkOf(const Image& image);

}  // namespace poinsot::image
