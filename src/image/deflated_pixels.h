// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::image {

/// Returns a picture as the compressed image data of a PNG file (PNG specification, clauses 7 to 10). Rows are
/// filtered, 16-bit samples are big-endian, and all data is one zlib stream.
/// The same pixels and the same version of ISA-L give the same bytes on every x86-64 CPU with SSE4.2 (Intel since
/// 2008, AMD since 2011). On other CPUs ISA-L compresses slightly differently.
std::vector<std::uint8_t> deflatedPixels(const Image& picture);
std::vector<std::uint8_t> deflatedPixels(const DeepImage& picture);

}  // namespace poinsot::image
