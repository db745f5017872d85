// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

/// Pixels of a picture that a comparison leaves out.
class IgnoreMask {
 public:
  /// A mask that leaves out nothing. @pre width, height > 0.
  explicit IgnoreMask(image::PixelSize size);

  /// Adds a box, as far as it lies in the picture.
  void add(const image::PixelRect& box);
  /// Adds the pixels at which `painted` is neither black nor wholly transparent. @pre same size.
  void add(const image::AnyImage& painted);

  image::PixelSize size() const { return size_; }
  /// @pre inside the picture.
  bool ignores(int x, int y) const;
  /// Whether a pixel is ignored, by its number, row by row. @pre inside the picture.
  bool ignoresPixel(std::size_t index) const { return ignored_.at(index) != 0; }
  std::int64_t ignoredPixels() const { return count_; }
  std::int64_t comparedPixels() const { return static_cast<std::int64_t>(ignored_.size()) - count_; }
  /// The ignored pixels as boxes that do not overlap, from the top left, `most` at most.
  std::vector<image::PixelRect> boxes(std::size_t most) const;
  /// Ignored part of all pixels, 0 to 1.
  double share() const { return static_cast<double>(count_) / static_cast<double>(ignored_.size()); }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x);
  }
  void ignore(int x, int y);

  image::PixelSize size_;
  std::vector<std::uint8_t> ignored_;
  std::int64_t count_ = 0;
};

/// Picture b with the ignored pixels of a, so that no measure sees a difference there.
/// @pre pictures and mask are of one size, the pictures of one sample type and number of channels.
template <typename Sample>
image::BasicImage<Sample> withIgnoredOf(const image::BasicImage<Sample>& a, image::BasicImage<Sample> b,
                                        const IgnoreMask& ignored);
image::AnyImage withIgnoredOf(const image::AnyImage& a, const image::AnyImage& b, const IgnoreMask& ignored);

}  // namespace poinsot::compare
