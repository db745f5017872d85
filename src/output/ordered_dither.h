// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "output/palette.h"

namespace poinsot::output {

/// Ordered dithering to the colours of a palette. A colour that the palette lacks is mixed of two of its colours,
/// by a fixed pattern of 8x8 pixels. Equal pixels at one place stay equal from picture to picture, so that nothing
/// flickers, and colours of the palette do not change.
class OrderedDither {
 public:
  /// @param palette  1 to 256 colours.
  explicit OrderedDither(std::vector<Rgb> palette);

  /// Writes the palette index of each pixel, row by row. Alpha is ignored.
  /// @param stride  indices from one row to the next.
  void apply(const image::Image& picture, std::span<std::uint8_t> indices, std::ptrdiff_t stride);

  const std::vector<Rgb>& palette() const { return palette_; }

 private:
  /// Mix of two colours: `second` in `share` of 64 pixels, `first` in the others.
  struct Mix {
    std::uint8_t first = 0, second = 0, share = 0;
    bool known = false;
  };
  Mix mixOf(const std::uint8_t* rgb) const;

  std::vector<Rgb> palette_;
  std::vector<Mix> mixes_;  // by colour, computed when the colour first occurs
};

}  // namespace poinsot::output
