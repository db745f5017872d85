// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "image/image.h"

/// Estimates of the memory that a comparison needs, before it starts.
namespace poinsot::compare {

struct PixelKind {
  bool transparent = false, deep = false;
};

/// Returns the peak memory for comparing two pictures, including maps, in bytes.
double compareMemory_bytes(image::PixelSize size, PixelKind kind = {});

/// Returns the peak memory for comparing two films, including maps, in bytes.
/// @param reading_bytes  memory of both readers; default: the least that any film needs
/// @param jobs  number of frames that are compared at a time
double compareFilmsMemory_bytes(image::PixelSize size, PixelKind kind = {},
                                std::optional<double> reading_bytes = {}, int jobs = 1);

/// Returns the largest film picture, in pixels, that can be compared within `bytes` of memory.
double largestFilmPicture_pixels(double bytes);

}  // namespace poinsot::compare
