// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Set of the pixels of a picture that edges of meshes cross.
class PixelMarks {
 public:
  static constexpr std::uint8_t kMarked = 255;

  /// Clears the marks. Only pixels within `part` can be marked and read afterwards.
  void reset(glm::ivec2 size_px, const PixelBounds& part);
  /// Marks every pixel that the segment touches, or misses only by a rounding error.
  void markSegment(glm::dvec2 a_px, glm::dvec2 b_px);
  void mark(const PixelBounds& bounds);
  /// Numbers the marked pixels row by row. Must be called after the last pixel was marked.
  void finish();

  std::size_t count() const { return columns_.size(); }
  glm::ivec2 size_px() const { return size_px_; }
  const PixelBounds& part() const { return part_; }
  /// Returns the number of the first marked pixel in a row or below it. For the row size_px().y, returns count().
  std::size_t firstOfRow(int row) const { return rowStarts_[static_cast<std::size_t>(row)]; }
  /// Returns the columns of all marked pixels, in the order of their numbers.
  std::span<const std::uint16_t> columns() const { return columns_; }
  /// Returns the marks of part() as data of a texture, row by row: kMarked or 0 for each pixel. The distance
  /// between rows is the width of the picture.
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
