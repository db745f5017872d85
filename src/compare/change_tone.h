// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "compare/ignore_mask.h"

namespace poinsot::compare {

/// A change that gave every value of a channel one new value, at every pixel that had it.
struct ToneChange {
  enum class Kind {
    kLevel,     ///< `level` was added
    kGain,      ///< values were multiplied by `factor`
    kContrast,  ///< distances from mid-grey were multiplied by `factor`
    kCurve      ///< another rising curve
  };
  Kind kind = Kind::kLevel;
  std::array<double, 4> level{};  ///< of red, green, blue, alpha; in 1/255
  double factor = 1;
};

/// Returns the change of tone that makes `test` from `reference`, results cut at black and full. Nothing if there
/// is none, or if too few values occur to tell it from another colour. @pre both have the same shape.
/// @param ignored  pixels that do not count; null for none
std::optional<ToneChange> toneChange(const image::Image& reference, const image::Image& test,
                                     const IgnoreMask* ignored);
std::optional<ToneChange> toneChange(const image::DeepImage& reference, const image::DeepImage& test,
                                     const IgnoreMask* ignored);

}  // namespace poinsot::compare
