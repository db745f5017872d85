// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot::compare {

class IgnoreMask {
 public:
  /// Makes a mask that ignores nothing. @pre width, height > 0.
  explicit IgnoreMask(image::PixelSize size);

  /// Adds a box, clipped to the picture.
  void add(const image::PixelRect& box);
  /// Adds the pixels where `painted` is neither black nor fully transparent. @pre same size.
  void add(const image::AnyImage& painted);

  image::PixelSize size() const { return size_; }
  /// Reports whether a pixel is ignored. @pre inside the picture.
  bool ignores(int x, int y) const;
  /// Reports whether a pixel is ignored. @param index pixel number, counted row by row. @pre inside the picture.
  bool ignoresPixel(std::size_t index) const { return ignored_.at(index) != 0; }
  std::int64_t ignoredPixels() const { return count_; }
  std::int64_t comparedPixels() const { return static_cast<std::int64_t>(ignored_.size()) - count_; }
  /// Returns the ignored pixels as disjoint boxes, from the top left. Boxes beyond the first `most` are left out.
  std::vector<image::PixelRect> boxes(std::size_t most) const;
  /// Returns the ignored fraction of all pixels, 0 to 1.
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

/// Returns picture b with the ignored pixels replaced by those of a, so that no measure sees a difference there.
/// @pre pictures and mask are of one size, the pictures of one sample type and number of channels.
template <typename Sample>
image::BasicImage<Sample> withIgnoredOf(const image::BasicImage<Sample>& a, image::BasicImage<Sample> b,
                                        const IgnoreMask& ignored);
image::AnyImage withIgnoredOf(const image::AnyImage& a, const image::AnyImage& b, const IgnoreMask& ignored);

}  // namespace poinsot::compare
