// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace poinsot::image {

/// One of a row of pictures, for the time of a call.
struct Frame {
  /// @param which  its number in the row, from 1; 0 of a picture that stands alone.
  Frame(const AnyImage& shown, std::uint64_t which = 0, std::span<const PixelRect> where = {})
      : picture(shown), number(which), changed(where) {}

  const AnyImage& picture;
  std::uint64_t number;
  std::span<const PixelRect> changed;  ///< where it may differ from the one numbered before it
};

}  // namespace poinsot::image
