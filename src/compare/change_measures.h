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

/// Region of a picture in which differing pixels lie close together.
struct ChangedPlace {
  image::PixelRect box;
  std::int64_t pixels = 0;  ///< number of differing pixels
  friend bool operator==(const ChangedPlace&, const ChangedPlace&) = default;
};

/// Groups differing pixels into places, for example all letters of a word into one place. Two differing pixels
/// belong to the same place if fewer than 8 equal pixels separate them. If 16 or more equal pixels separate them,
/// they belong to the same place only if other differing pixels connect them.
class PlaceFinder {
 public:
  explicit PlaceFinder(image::PixelSize size);
  void add(int x, int y) {
    ChangedPlace& here = cell(x / kCell, y / kCell);
    if (here.pixels++ == 0) here.box = {x, y, x, y};
    here.box = {std::min(here.box.left, x), std::min(here.box.top, y), std::max(here.box.right, x + 1),
                std::max(here.box.bottom, y + 1)};
  }

  /// Returns the places, sorted by falling number of differing pixels, then by top and left edge. The call empties
  /// the finder.
  std::vector<ChangedPlace> places();

 private:
  static constexpr int kCell = 8;  // side of a cell, in pixels

  /// Removes a cell and all cells connected to it, and returns them as one place.
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

/// Largest shift that shiftOf() can find, in pixels along each axis.
inline constexpr int kLargestShift = 16;

/// Returns the shift that turns the reference into the test within `box`, up to kLargestShift along each axis.
/// Each sample of the reference in the box must be at its shifted position in the test. Each sample of the test in
/// the box must come from the reference. Positions outside the picture do not count. Returns nullopt if no shift
/// fits, or if several shifts fit.
/// @param changed  number of differing pixels in the box
std::optional<Shift> shiftOf(const image::Image& reference, const image::Image& test, const image::PixelRect& box,
                             std::int64_t changed);
std::optional<Shift> shiftOf(const image::DeepImage& reference, const image::DeepImage& test,
                             const image::PixelRect& box, std::int64_t changed);

/// Mistakes of programs that read pixels: rows in reverse order, columns in reverse order, red and blue exchanged.
enum class Symmetry { kUpsideDown, kMirrored, kRedAndBlueExchanged };

/// Returns the symmetry that turns `reference` into `test`; nullopt if there is none.
/// @pre both have the same shape, and differ.
std::optional<Symmetry> symmetryOf(const image::Image& reference, const image::Image& test);
std::optional<Symmetry> symmetryOf(const image::DeepImage& reference, const image::DeepImage& test);

/// Change of brightness or colour in which equal old values of a channel always become equal new values.
struct ToneChange {
  enum class Kind {
    kLevel,     ///< `level` was added to all values
    kGain,      ///< values were multiplied by `factor`
    kContrast,  ///< distances from mid-grey were multiplied by `factor`
    kCurve      ///< values were mapped by some other rising curve
  };
  Kind kind = Kind::kLevel;
  std::array<double, 4> level{};  ///< kLevel: change of red, green, blue, alpha, in 1/255
  double factor = 1;
};

/// Returns the change of tone that turns `reference` into `test`. Results outside the sample's range are clipped.
/// Returns nullopt if there is no such change, or if too few different values occur to tell a change of tone from
/// a recoloured area.
/// @pre both have the same shape.
/// @param ignored  pixels that do not count; null for none
std::optional<ToneChange> toneChange(const image::Image& reference, const image::Image& test,
                                     const IgnoreMask* ignored);
std::optional<ToneChange> toneChange(const image::DeepImage& reference, const image::DeepImage& test,
                                     const IgnoreMask* ignored);

}  // namespace poinsot::compare
