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

/// Most frequent change from one colour to another. Recorded only if more than a fifth of the differing pixels
/// have it.
struct Recolouring {
  std::string from, to;  ///< such as "#1f77b4"; 16-bit colours have four digits per channel
  std::int64_t pixels = 0;
};

/// Differences between two pictures of the same shape: where they are, and what changed.
struct Changes {
  static constexpr std::size_t kMostPlaces = 100;

  image::PixelSize size;
  std::int64_t pixels = 0;         ///< number of pixels that differ in any channel
  double largest = 0;              ///< largest difference of a channel, in 1/255
  std::array<bool, 4> channels{};  ///< whether red, green, blue, alpha differ anywhere
  image::PixelRect box;
  std::int64_t placeCount = 0;          ///< number of places, including those not in `places`
  std::vector<ChangedPlace> places;     ///< at most kMostPlaces, by falling number of pixels
  std::optional<ToneChange> tone;       ///< change of tone that explains all differing pixels
  std::optional<Symmetry> symmetry;     ///< symmetry that explains all differing pixels, if there is no `tone`
  std::optional<Shift> shift;           ///< shift that explains all places, if there is no tone or symmetry
  std::optional<Shift> shiftOfLargest;  ///< shift of the largest place, if there is no common `shift`
  std::optional<Recolouring> recolouring;
};

/// Finds the differences between two pictures, in time proportional to the number of pixels.
/// @pre both have the same size and number of channels.
/// @param ignored  mask of the pixels that do not count, of the pictures' size; null if all count
Changes changesBetween(const image::AnyImage& reference, const image::AnyImage& test,
                       const IgnoreMask* ignored = nullptr);

/// Describes the changes in one clause, such as "87 pixels in one place of 40x24 px at (460, 340)", "brighter by 2
/// everywhere" or "the picture moved by 1 px to the right". Returns an empty string for identical pictures.
std::string wordsOf(const Changes& changes);

/// Returns what kind of change it is, without its place and extent, such as "moved by 1 px to the right" or
/// "#1f77b4 became #ff7f0e". Returns an empty string for identical pictures.
std::string kindOf(const Changes& changes);

}  // namespace poinsot::compare
