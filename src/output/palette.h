// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"

namespace poinsot::output {

using Rgb = std::array<std::uint8_t, 3>;

/// Checks that libimagequant, which computes the palette, is available. Call before pictures are drawn.
/// @throws core::Error(kEncode) if libimagequant cannot be opened.
void checkPaletteMaker();

/// Computes a palette for the colours of many pictures, with libimagequant. Uses one thread, so that the same
/// pictures give the same palette.
class PaletteMaker {
 public:
  /// @param most  2 to 256 colours. @throws core::Error as checkPaletteMaker().
  explicit PaletteMaker(int most);
  ~PaletteMaker();
  PaletteMaker(const PaletteMaker&) = delete;
  PaletteMaker& operator=(const PaletteMaker&) = delete;

  /// Adds the colours of a picture; alpha is ignored.
  void add(const image::Image& picture);
  /// Returns the palette. Call once, after at least one picture.
  std::vector<Rgb> palette();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::output
