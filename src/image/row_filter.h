// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poinsot::image {

/// Filters the rows of a picture from top to bottom: replaces pixels by their differences from neighbours (PNG
/// specification, clause 9). A plain background becomes zeros, and gradients become small numbers, which compress
/// well. For each row, the filters Sub, Up and Paeth are tried. The one with the fewest bytes other than 0 is
/// used, the first of equals.
class RowFilter {
 public:
  /// @param rowBytes  number of bytes in a row, without the number of the filter
  /// @param pixelBytes  number of bytes in a pixel. @pre both > 0
  RowFilter(std::size_t rowBytes, std::size_t pixelBytes);

  /// Returns the memory to which the caller writes the next row of `rowBytes` bytes. The last row becomes the row
  /// above.
  std::uint8_t* next();

  /// Returns the number of the filter and the filtered bytes of the current row. Valid until the next call.
  std::span<const std::uint8_t> filtered();

 private:
  /// Row of pixels with one pixel of zeros before the first, because the first pixel has no left neighbour.
  using PaddedRow = std::vector<std::uint8_t>;

  /// Number of a filter and the row filtered with it. `others` is the number of bytes that are not 0.
  struct Candidate {
    std::vector<std::uint8_t> bytes;
    std::size_t others = 0;
  };

  void filterChunk(std::size_t begin, std::size_t size);

  std::size_t rowBytes_, pixelBytes_;
  PaddedRow row_, above_;
  /// For each chunk of a row: whether every pixel equals the pixel to its left
  std::vector<char> flat_, flatAbove_;
  Candidate sub_, up_, paeth_;
};

}  // namespace poinsot::image
