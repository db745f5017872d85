// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::image {

/// The picture as a PNG's image data holds it (PNG specification, clauses 7 to 10): rows filtered, samples of 16
/// bits big-endian, in one zlib stream. The same pixels give the same bytes, for one version of ISA-L and on every
/// x86-64 CPU with SSE4.2 (of Intel since 2008, of AMD since 2011); on others ISA-L compresses a little otherwise.
std::vector<std::uint8_t> deflatedPixels(const Image& picture);
std::vector<std::uint8_t> deflatedPixels(const DeepImage& picture);

}  // namespace poinsot::image
