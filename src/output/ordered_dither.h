// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "output/palette.h"

namespace poinsot::output {

/// Ordered dithering to the colours of a palette. Any other colour is mixed from two of the palette's colours, in
/// a fixed pattern of 8x8 pixels. A pixel that does not change from one picture to the next keeps its result, so
/// that nothing flickers.
class OrderedDither {
 public:
  /// @param palette  1 to 256 colours.
  explicit OrderedDither(std::vector<Rgb> palette);

  /// Writes the palette index of each pixel, row by row. Ignores alpha.
  /// @param stride  number of indices from the start of one row to the next.
  void apply(const image::Image& picture, std::span<std::uint8_t> indices, std::ptrdiff_t stride);

  const std::vector<Rgb>& palette() const { return palette_; }

 private:
  /// Mix of two palette colours: `share` of the pattern's 64 pixels have colour `second`, the others `first`.
  struct Mix {
    std::uint8_t first = 0, second = 0, share = 0;
    bool known = false;
  };
  Mix mixOf(const std::uint8_t* rgb) const;

  std::vector<Rgb> palette_;
  std::vector<Mix> mixes_;  // one for each RGB colour, computed on first use
};

}  // namespace poinsot::output
