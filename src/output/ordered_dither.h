// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "output/palette.h"

namespace poinsot::output {

/// Shows pictures in the colours of a palette. A colour that is not there is mixed of two that are, by a fixed
/// pattern of 8x8 pixels: equal pixels at one place stay equal from picture to picture, so that nothing boils, and
/// colours of the palette stay themselves.
class OrderedDither {
 public:
  /// @param palette  1 to 256 colours.
  explicit OrderedDither(std::vector<Rgb> palette);

  /// Index into the palette for each pixel, row by row; alpha is left out.
  void apply(const image::Image& picture, std::span<std::uint8_t> indices, std::ptrdiff_t stride);

  const std::vector<Rgb>& palette() const { return palette_; }

 private:
  /// `second` in so many of 64 pixels, `first` in the others.
  struct Mix {
    std::uint8_t first = 0, second = 0, share = 0;
    bool known = false;
  };
  Mix mixOf(const std::uint8_t* rgb) const;

  std::vector<Rgb> palette_;
  std::vector<Mix> mixes_;  // by colour, found when first met
};

}  // namespace poinsot::output
