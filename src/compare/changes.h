// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/change_measures.h"
#include "image/image.h"

namespace poinsot::compare {

/// Most frequent change from one colour to another; recorded if more than a fifth of the differing pixels have it.
struct Recolouring {
  std::string from, to;  ///< as in CSS, "#1f77b4"; four digits per channel for 16 bits
  std::int64_t pixels = 0;
};

/// Places and kinds of the differences between two pictures of one shape, independent of any rule.
struct Changes {
  static constexpr std::size_t kMostPlaces = 100;

  image::PixelSize size;
  std::int64_t pixels = 0;         ///< number of pixels that differ in any channel
  double largest = 0;              ///< largest difference of a channel, in 1/255
  std::array<bool, 4> channels{};  ///< whether red, green, blue, alpha differ anywhere
  image::PixelRect box;
  std::int64_t placeCount = 0;          ///< number of places found, including those dropped from `places`
  std::vector<ChangedPlace> places;     ///< places by falling number of pixels, at most kMostPlaces
  std::optional<ToneChange> tone;       ///< tone that explains all differing pixels
  std::optional<Symmetry> symmetry;     ///< symmetry that explains all differing pixels, if there is no `tone`
  std::optional<Shift> shift;           ///< shift that explains all places, if there is neither tone nor symmetry
  std::optional<Shift> shiftOfLargest;  ///< shift of the largest of several places
  std::optional<Recolouring> recolouring;
};

/// Finds what differs between two pictures, deterministically, in time proportional to the number of pixels.
/// @pre both have the same size and number of channels.
/// @param ignored  mask of the same size with the pixels that do not count; null if all count
Changes changesBetween(const image::AnyImage& reference, const image::AnyImage& test,
                       const IgnoreMask* ignored = nullptr);

/// Describes the changes in one clause: "87 pixels in one place of 40x24 px at (460, 340)", "brighter by 2
/// everywhere", "the picture moved by 1 px to the right". Returns an empty string for identical pictures.
std::string wordsOf(const Changes& changes);

}  // namespace poinsot::compare
