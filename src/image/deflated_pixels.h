// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::image {

/// Returns the picture as a PNG's image data (PNG specification, clauses 7 to 10): rows filtered, 16-bit samples
/// big-endian, in one zlib stream. Equal pixels give equal bytes for one version of ISA-L on every x86-64 CPU with
/// SSE4.2 (Intel since 2008, AMD since 2011); on other CPUs ISA-L compresses slightly differently.
std::vector<std::uint8_t> deflatedPixels(const Image& picture);
std::vector<std::uint8_t> deflatedPixels(const DeepImage& picture);

}  // namespace poinsot::image
