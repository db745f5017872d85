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

/// Cluster of differing pixels that lie close together.
struct ChangedPlace {
  image::PixelRect box;
  std::int64_t pixels = 0;  ///< number of differing pixels
  friend bool operator==(const ChangedPlace&, const ChangedPlace&) = default;
};

/// Clusters differing pixels into places. Pixels with fewer than 8 equal ones between them always share a place.
/// Pixels with 16 or more never do, unless others connect them. The letters of a word thus form one place.
class PlaceFinder {
 public:
  explicit PlaceFinder(image::PixelSize size);
  void add(int x, int y) {
    ChangedPlace& here = cell(x / kCell, y / kCell);
    if (here.pixels++ == 0) here.box = {x, y, x, y};
    here.box = {std::min(here.box.left, x), std::min(here.box.top, y), std::max(here.box.right, x + 1),
                std::max(here.box.bottom, y + 1)};
  }

  /// Returns the places by falling number of pixels; ties are ordered from the top left. Call once.
  std::vector<ChangedPlace> places();

 private:
  static constexpr int kCell = 8;  // side of a cell, in pixels

  /// Takes a cell with all cells connected to it as one place, and empties these cells.
  ChangedPlace placeFrom(int column, int row);
  ChangedPlace& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  int columns_, rows_;
  std::vector<ChangedPlace> cells_;
};

/// Displacement in pixels, positive to the right and down.
struct Shift {
  int x = 0, y = 0;
  friend bool operator==(const Shift&, const Shift&) = default;
};

/// Largest shift along an axis for which shiftOf() searches, in pixels.
inline constexpr int kLargestShift = 16;

/// Returns the shift, up to kLargestShift along each axis, that turns the reference into the test within `box`.
/// All reference samples of the box must be at their new places in the test, and all test samples of the box must
/// come from their old places; places outside the picture do not count. Returns nullopt if no shift fits, or if
/// several do.
/// @param changed  number of differing pixels in the box
std::optional<Shift> shiftOf(const image::Image& reference, const image::Image& test, const image::PixelRect& box,
                             std::int64_t changed);
std::optional<Shift> shiftOf(const image::DeepImage& reference, const image::DeepImage& test,
                             const image::PixelRect& box, std::int64_t changed);

/// Errors of programs that read pixels back: rows from the bottom, columns from the right, blue before red.
enum class Symmetry { kUpsideDown, kMirrored, kRedAndBlueExchanged };

/// Returns the symmetry that turns `reference` into `test`. @pre both have the same shape, and differ.
std::optional<Symmetry> symmetryOf(const image::Image& reference, const image::Image& test);
std::optional<Symmetry> symmetryOf(const image::DeepImage& reference, const image::DeepImage& test);

/// Change of tone: every value of a channel was replaced by one new value at all pixels that had it.
struct ToneChange {
  enum class Kind {
    kLevel,     ///< `level` was added
    kGain,      ///< values were multiplied by `factor`
    kContrast,  ///< distances from mid-grey were multiplied by `factor`
    kCurve      ///< values were mapped by another rising curve
  };
  Kind kind = Kind::kLevel;
  std::array<double, 4> level{};  ///< change of red, green, blue, alpha, in 1/255
  double factor = 1;
};

/// Returns the change of tone that turns `reference` into `test`, with results clipped to the sample's range.
/// Returns nullopt if there is none, or if too few values occur to distinguish a tone from another colour.
/// @pre both have the same shape.
/// @param ignored  pixels that do not count; null for none
std::optional<ToneChange> toneChange(const image::Image& reference, const image::Image& test,
                                     const IgnoreMask* ignored);
std::optional<ToneChange> toneChange(const image::DeepImage& reference, const image::DeepImage& test,
                                     const IgnoreMask* ignored);

}  // namespace poinsot::compare
