// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "image/image.h"

namespace poinsot::compare {

/// Pixels that something moved, to the right and down.
struct Shift {
  int x = 0, y = 0;
  friend bool operator==(const Shift&, const Shift&) = default;
};

/// Largest shift along an axis that is looked for, in pixels.
inline constexpr int kLargestShift = 16;

/// Returns the smallest shift that turns the reference into the test within `box`: what was in the box is found at
/// its new place and what is in the box comes from its old place, sample by sample, except where the other end
/// lies outside the picture. Nothing if there is none. @param changed  number of differing pixels in the box.
std::optional<Shift> shiftOf(const image::Image& reference, const image::Image& test, const image::PixelRect& box,
                             std::int64_t changed);
std::optional<Shift> shiftOf(const image::DeepImage& reference, const image::DeepImage& test,
                             const image::PixelRect& box, std::int64_t changed);

}  // namespace poinsot::compare
