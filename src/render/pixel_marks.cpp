// SPDX-License-Identifier: Apache-2.0
#include "render/pixel_marks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace poinsot::render {
namespace {

// Distance around a segment within which pixels are marked too. It allows for OpenGL's grid of 1/256 pixel.
constexpr double kRounding_px = 1.0 / 128;

}  // namespace

void PixelMarks::reset(glm::ivec2 size_px, const PixelBounds& part) {
  // Only the previous part can contain marks.
  if (size_px == size_px_) {
    for (int row = top(); row < bottom(); ++row)
      std::memset(&marks_[indexOf(left(), row)], 0, static_cast<std::size_t>(right() - left()));
  } else {
    size_px_ = size_px;
    marks_.assign(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y), 0);
  }
  part_ = part.clipped(size_px);
  if (part_.empty()) part_ = {0, 0, 0, 0};
  columns_.clear();
  rowStarts_.assign(static_cast<std::size_t>(size_px.y) + 1, 0);
}

void PixelMarks::markRow(int row, double left_px, double right_px) {
  const double from = std::max<double>(std::floor(left_px), left()),
               to = std::min<double>(std::floor(right_px), right() - 1);
  if (from > to) return;
  std::memset(&marks_[indexOf(static_cast<int>(from), row)], kMarked, static_cast<std::size_t>(to - from) + 1);
}

void PixelMarks::markSegment(glm::dvec2 a, glm::dvec2 b) {
  if (a.y > b.y) std::swap(a, b);
  const double first = std::max<double>(std::floor(a.y - kRounding_px), top());
  const double last = std::min<double>(std::floor(b.y + kRounding_px), bottom() - 1);
  const double slope = b.y - a.y > 1e-9 ? (b.x - a.x) / (b.y - a.y) : 0;
  for (double row = first; row <= last; ++row) {
    const bool level = b.y - a.y <= 1e-9;
    const double x0 = level ? a.x : a.x + slope * (std::clamp(row - kRounding_px, a.y, b.y) - a.y);
    const double x1 = level ? b.x : a.x + slope * (std::clamp(row + 1 + kRounding_px, a.y, b.y) - a.y);
    markRow(static_cast<int>(row), std::min(x0, x1) - kRounding_px, std::max(x0, x1) + kRounding_px);
  }
}

void PixelMarks::mark(const PixelBounds& bounds) {
  const PixelBounds b = bounds.clipped(size_px_);
  for (float row = std::max(b.top, part_.top); row < std::min(b.bottom, part_.bottom); ++row)
    markRow(static_cast<int>(row), static_cast<double>(b.left), static_cast<double>(b.right) - 1);
}

void PixelMarks::finish() {
  columns_.clear();
  for (int y = top(); y < bottom(); ++y) {
    rowStarts_[static_cast<std::size_t>(y)] = columns_.size();
    const std::uint8_t* row = &marks_[indexOf(0, y)];
    const std::uint8_t *end = row + right(), *at = row + left();
    while ((at = static_cast<const std::uint8_t*>(std::memchr(at, kMarked, static_cast<std::size_t>(end - at)))))
      columns_.push_back(static_cast<std::uint16_t>(at++ - row));
  }
  std::fill(rowStarts_.begin() + bottom(), rowStarts_.end(), columns_.size());
}

}  // namespace poinsot::render
