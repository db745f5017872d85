// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"

namespace poinsot::output {

using Rgb = std::array<std::uint8_t, 3>;

/// @throws core::Error(kEncode) if there is no libimagequant, before pictures are drawn for it.
void checkPaletteMaker();

/// The colours of many pictures, reduced to a few that stand for all of them. libimagequant's, on one thread: the
/// same pictures give the same palette.
class PaletteMaker {
 public:
  /// @param most  2 to 256. @throws core::Error as checkPaletteMaker().
  explicit PaletteMaker(int most);
  ~PaletteMaker();
  PaletteMaker(const PaletteMaker&) = delete;
  PaletteMaker& operator=(const PaletteMaker&) = delete;

  /// Takes part in the choice; alpha does not.
  void add(const image::Image& picture);
  /// Once, after at least one picture.
  std::vector<Rgb> palette();

 private:
  struct Parts;  // keeps the library's header out of this one
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::output
