// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace poinsot::image {

/// One picture of a sequence, valid during the call to which it is passed.
struct Frame {
  /// @param which  number of the picture in the sequence, from 1; 0 if the picture belongs to no sequence
  Frame(const AnyImage& shown, std::uint64_t which = 0, std::span<const PixelRect> where = {})
      : picture(shown), number(which), changed(where) {}

  const AnyImage& picture;
  std::uint64_t number;
  std::span<const PixelRect> changed;  ///< rectangles that may differ from the picture with the previous number
};

}  // namespace poinsot::image
