// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace poinsot::image {

/// One picture of a sequence, valid for the time of a call.
struct Frame {
  /// @param which  number of the picture in the sequence, from 1; 0 if the picture stands alone.
  Frame(const AnyImage& shown, std::uint64_t which = 0, std::span<const PixelRect> where = {})
      : picture(shown), number(which), changed(where) {}

  const AnyImage& picture;
  std::uint64_t number;
  std::span<const PixelRect> changed;  ///< where it may differ from the picture numbered before it
};

}  // namespace poinsot::image
