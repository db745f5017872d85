// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Which tiles of the picture something is drawn in.
class TileMask {
 public:
  static constexpr int kTile_px = 64;  // llvmpipe's own tile

  TileMask() = default;
  explicit TileMask(glm::vec2 size_px);

  /// Marks every tile that the rectangle touches.
  void mark(const PixelBounds& bounds);
  bool marked(int column, int row) const { return marks_[index(column, row)]; }
  bool any() const { return any_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  PixelBounds tile(int column, int row) const;

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }

  glm::vec2 size_px_{0};
  int columns_ = 0, rows_ = 0;
  bool any_ = false;
  std::vector<bool> marks_;
};

}  // namespace poinsot::render
