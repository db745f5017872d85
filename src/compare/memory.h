// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "image/image.h"

/// The memory that a comparison takes, known before it begins.
namespace poinsot::compare {

/// The form of pixels: with transparency or not, of 8 or 16 bits.
struct PixelKind {
  bool transparent = false, deep = false;
};

/// Bytes that comparing two pictures of a size takes at its peak, maps included.
double compareMemory_bytes(image::PixelSize size, PixelKind kind = {});

/// Bytes that comparing two films takes at its peak, so many frames at a time, maps included.
/// @param reading_bytes  taken by both readers. The default is the least that any film takes.
double compareFilmsMemory_bytes(image::PixelSize size, PixelKind kind = {},
                                std::optional<double> reading_bytes = {}, int jobs = 1);

/// Returns how large pictures of films may be, so that comparing them takes no more than this.
double largestFilmPicture_pixels(double bytes);

}  // namespace poinsot::compare
