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

/// The most frequent change of one colour to another, if it is that of a fifth of the differing pixels or more.
struct Recolouring {
  std::string from, to;  ///< "#1f77b4", as CSS writes colours; four digits a channel for 16 bits
  std::int64_t pixels = 0;
};

/// Where and how two pictures of one shape differ, whatever rule judges them.
struct Changes {
  /// Number of places that are kept.
  static constexpr std::size_t kMostPlaces = 100;

  image::PixelSize size;                ///< of both pictures
  std::int64_t pixels = 0;              ///< that differ in any channel
  double largest = 0;                   ///< difference of a channel, in 1/255
  std::array<bool, 4> channels{};       ///< which of red, green, blue and alpha differ anywhere
  image::PixelRect box;                 ///< around all differing pixels
  std::int64_t placeCount = 0;          ///< of places found
  std::vector<ChangedPlace> places;     ///< the one with most pixels first; at most kMostPlaces
  std::optional<ToneChange> tone;       ///< explains all differing pixels
  std::optional<Symmetry> symmetry;     ///< explains all differing pixels, if `tone` does not
  std::optional<Shift> shift;           ///< explains all places, if `tone` does not
  std::optional<Shift> shiftOfLargest;  ///< explains the first of several places
  std::optional<Recolouring> recolouring;
};

/// Finds what differs between two pictures. Takes time in proportion to the number of pixels; the same pictures
/// always give the same result. @pre both have the same size and number of channels.
/// @param ignored  mask of that size: pixels that do not count; without one all count
Changes changesBetween(const image::AnyImage& reference, const image::AnyImage& test,
                       const IgnoreMask* ignored = nullptr);

/// Describes the changes in one clause: "87 pixels in one place of 40x24 px at (460, 340)", "brighter by 2
/// everywhere", "the picture moved by 1 px to the right". Empty for identical pictures.
std::string wordsOf(const Changes& changes);

}  // namespace poinsot::compare
