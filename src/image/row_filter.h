// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poinsot::image {

/// Filters the rows of a picture, from the top, into differences from neighbours to the left or above (PNG
/// specification, clause 9). Paper becomes zeros, and a slow gradient becomes small numbers. Of the filters Sub,
/// Up and Paeth, each row gets the one that leaves the fewest bytes other than 0; ties go to the first in this
/// order.
class RowFilter {
 public:
  /// @param rowBytes  bytes of a row, without the filter's number
  /// @param pixelBytes  bytes of a pixel, which is the distance to the byte on the left. @pre both > 0
  RowFilter(std::size_t rowBytes, std::size_t pixelBytes);

  /// Returns where to write the `rowBytes` bytes of the next row. The previous row becomes the row above.
  std::uint8_t* next();

  /// Returns the filter's number and the filtered bytes of the current row, valid until the next call.
  std::span<const std::uint8_t> filtered();

 private:
  /// Row after one pixel of zeros, which stands to the left of the first pixel.
  using PaddedRow = std::vector<std::uint8_t>;

  /// Filter number and the row filtered with it; `others` counts the bytes that are not 0.
  struct Candidate {
    std::vector<std::uint8_t> bytes;
    std::size_t others = 0;
  };

  void filterChunk(std::size_t begin, std::size_t size);

  std::size_t rowBytes_, pixelBytes_;
  PaddedRow row_, above_;
  std::vector<char> flat_, flatAbove_;  ///< by chunk: whether each pixel equals the one before it
  Candidate sub_, up_, paeth_;
};

}  // namespace poinsot::image
