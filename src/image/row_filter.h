// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poinsot::image {

/// The rows of a picture, from the top, as differences from what is beside or above them (PNG specification,
/// clause 9): paper becomes zeros, and a shade that changes slowly a few small numbers. Of sub, up and Paeth each
/// row gets the filter that leaves the fewest bytes other than 0; the first named, where two leave as many.
class RowFilter {
 public:
  /// @param rowBytes    of a row, without the number of its filter.
  /// @param pixelBytes  of a pixel: how far to the left what a byte is compared with lies. @pre both > 0
  RowFilter(std::size_t rowBytes, std::size_t pixelBytes);

  /// Where the bytes of the next row are to be written, `rowBytes` of them. The one before is now that above.
  std::uint8_t* next();

  /// That row, filtered: the number of its filter, then `rowBytes`. Until this is called again.
  std::span<const std::uint8_t> filtered();

 private:
  /// A row after one pixel of zeros, which is what lies to the left of its first.
  using PaddedRow = std::vector<std::uint8_t>;

  /// A filter's number, then the row as it leaves it.
  struct Candidate {
    std::vector<std::uint8_t> bytes;
    std::size_t others = 0;  ///< bytes that are not 0
  };

  void filterChunk(std::size_t begin, std::size_t size);

  std::size_t rowBytes_, pixelBytes_;
  PaddedRow row_, above_;
  std::vector<char> flat_, flatAbove_;  ///< by chunk: whether each pixel is the one before it
  Candidate sub_, up_, paeth_;
};

}  // namespace poinsot::image
