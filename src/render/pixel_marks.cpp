// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_marks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace poinsot::render {
namespace {

// Beside a segment, for rounding and for OpenGL's own grid of 1/256 pixel.
constexpr double kMargin_px = 1.0 / 128;

}  // namespace

void PixelMarks::reset(glm::ivec2 size_px) {
  size_px_ = size_px;
  marks_.assign(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y), 0);
  columns_.clear();
  rowStarts_.assign(static_cast<std::size_t>(size_px.y) + 1, 0);
}

void PixelMarks::markRow(int row, double left_px, double right_px) {
  const double last = size_px_.x - 1;
  const double from = std::max(std::floor(left_px), 0.0), to = std::min(std::floor(right_px), last);
  if (from > to) return;
  std::uint8_t* begin = marks_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(size_px_.x);
  std::memset(begin + static_cast<std::size_t>(from), kMarked, static_cast<std::size_t>(to - from) + 1);
}

void PixelMarks::markSegment(glm::dvec2 a, glm::dvec2 b) {
  if (a.y > b.y) std::swap(a, b);
  const double top = std::max(std::floor(a.y - kMargin_px), 0.0);
  const double bottom = std::min(std::floor(b.y + kMargin_px), size_px_.y - 1.0);
  const double slope = b.y - a.y > 1e-9 ? (b.x - a.x) / (b.y - a.y) : 0;
  for (double row = top; row <= bottom; ++row) {
    // The part of the segment within this row of pixels.
    const bool level = b.y - a.y <= 1e-9;
    const double x0 = level ? a.x : a.x + slope * (std::clamp(row - kMargin_px, a.y, b.y) - a.y);
    const double x1 = level ? b.x : a.x + slope * (std::clamp(row + 1 + kMargin_px, a.y, b.y) - a.y);
    markRow(static_cast<int>(row), std::min(x0, x1) - kMargin_px, std::max(x0, x1) + kMargin_px);
  }
}

void PixelMarks::mark(const PixelBounds& bounds) {
  const PixelBounds b = bounds.clipped(size_px_);
  for (float row = b.top; row < b.bottom; ++row)
    markRow(static_cast<int>(row), static_cast<double>(b.left), static_cast<double>(b.right) - 1);
}

void PixelMarks::finish() {
  columns_.clear();
  const std::uint8_t* row = marks_.data();
  for (int y = 0; y < size_px_.y; ++y, row += size_px_.x) {
    rowStarts_[static_cast<std::size_t>(y)] = columns_.size();
    const std::uint8_t *end = row + size_px_.x, *at = row;
    while ((at = static_cast<const std::uint8_t*>(std::memchr(at, kMarked, static_cast<std::size_t>(end - at)))))
      columns_.push_back(static_cast<std::uint16_t>(at++ - row));
  }
  rowStarts_.back() = columns_.size();
}

}  // namespace poinsot::render
