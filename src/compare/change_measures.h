// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compare/ignore_mask.h"
#include "image/image.h"

namespace poinsot::compare {

/// Differing pixels that lie close together.
struct ChangedPlace {
  image::PixelRect box;     ///< the smallest around them
  std::int64_t pixels = 0;  ///< that differ
  friend bool operator==(const ChangedPlace&, const ChangedPlace&) = default;
};

/// Collects differing pixels into places. Pixels with fewer than 8 equal ones between them always share a place,
/// pixels with 16 or more never do unless others connect them: letters of a word are one place.
class PlaceFinder {
 public:
  explicit PlaceFinder(image::PixelSize size);
  void add(int x, int y) {
    ChangedPlace& here = cell(x / kCell, y / kCell);
    if (here.pixels++ == 0) here.box = {x, y, x, y};
    here.box = {std::min(here.box.left, x), std::min(here.box.top, y), std::max(here.box.right, x + 1),
                std::max(here.box.bottom, y + 1)};
  }

  /// Returns the places, the one with most pixels first, those of equal count from the top left. Call once.
  std::vector<ChangedPlace> places();

 private:
  static constexpr int kCell = 8;  // pixels a side

  /// Takes the place that grows from a cell over its neighbours, and leaves their cells empty.
  ChangedPlace placeFrom(int column, int row);
  ChangedPlace& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  int columns_, rows_;
  std::vector<ChangedPlace> cells_;
};

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

/// Slips of programs that read pixels back: rows from the bottom, columns from the right, blue before red.
enum class Symmetry { kUpsideDown, kMirrored, kRedAndBlueExchanged };

/// Returns the one that makes `test` from `reference`. @pre both have the same shape, and differ.
std::optional<Symmetry> symmetryOf(const image::Image& reference, const image::Image& test);
std::optional<Symmetry> symmetryOf(const image::DeepImage& reference, const image::DeepImage& test);

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
