// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Marked pixels of a picture: those that an edge runs through.
class PixelMarks {
 public:
  static constexpr std::uint8_t kMarked = 255;

  /// Empty marks for this part of a picture of this size. Beside the part nothing is marked, nor is it asked for.
  void reset(glm::ivec2 size_px, const PixelBounds& part);
  /// Marks every pixel that the segment touches, and those it misses by rounding only.
  void markSegment(glm::dvec2 a_px, glm::dvec2 b_px);
  /// Marks every pixel that the rectangle touches.
  void mark(const PixelBounds& bounds);
  /// Numbers the marked pixels row by row; to be called when all are marked.
  void finish();

  std::size_t count() const { return columns_.size(); }
  glm::ivec2 size_px() const { return size_px_; }
  /// Whole pixels of the picture.
  const PixelBounds& part() const { return part_; }
  /// Number of the first marked pixel of a row; row size_px().y is beyond the last.
  std::size_t firstOfRow(int row) const { return rowStarts_[static_cast<std::size_t>(row)]; }
  /// Columns of all marked pixels, by number.
  std::span<const std::uint16_t> columns() const { return columns_; }
  /// kMarked or 0, row by row from the part's first pixel, for a texture; the rows are as long as the picture's.
  const std::uint8_t* bytes() const { return marks_.data() + indexOf(left(), top()); }

 private:
  int left() const { return static_cast<int>(part_.left); }
  int top() const { return static_cast<int>(part_.top); }
  int right() const { return static_cast<int>(part_.right); }
  int bottom() const { return static_cast<int>(part_.bottom); }
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_px_.x) + static_cast<std::size_t>(column);
  }
  void markRow(int row, double left_px, double right_px);

  glm::ivec2 size_px_{0};
  PixelBounds part_{0, 0, 0, 0};
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint16_t> columns_;
  std::vector<std::size_t> rowStarts_;
};

}  // namespace poinsot::render
