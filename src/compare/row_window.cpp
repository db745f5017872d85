// SPDX-License-Identifier: Apache-2.0
#include "compare/row_window.h"

#include <algorithm>

#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {

RowWindow::RowWindow(image::PixelSize size, int planes, int radius, Source source)
    : size_(size), planes_(planes), radius_(radius), source_(std::move(source)) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0 && planes > 0 && radius >= 0);
  values_.resize(static_cast<std::size_t>(planes) * static_cast<std::size_t>(2 * radius + 1) *
                 static_cast<std::size_t>(size.width));
}

double* RowWindow::slot(int plane, int y) {
  const int rows = 2 * radius_ + 1;
  return &values_[static_cast<std::size_t>(plane * rows + y % rows) * static_cast<std::size_t>(size_.width)];
}

void RowWindow::moveTo(int y) {
  POINSOT_EXPECT(y >= middle_ && y < size_.height);
  core::checkInterruption();  // every measure with a filter moves through the rows of large pictures
  middle_ = y;
  made_ = std::max(made_, y - radius_);
  std::vector<double*> rows(static_cast<std::size_t>(planes_));
  for (; made_ <= std::min(y + radius_, size_.height - 1); ++made_) {
    for (int k = 0; k < planes_; ++k) rows[static_cast<std::size_t>(k)] = slot(k, made_);
    source_(made_, rows);
  }
}

const double* RowWindow::row(int plane, int offset) const {
  const int y = std::clamp(middle_ + offset, 0, size_.height - 1);
  return const_cast<RowWindow*>(this)->slot(plane, y);
}

}  // namespace poinsot::compare
