// SPDX-License-Identifier: Apache-2.0
#include "compare/kernel.h"

#include <algorithm>
#include <cstring>

#include "compare/vectorised.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {

namespace {

typedef double Four __attribute__((vector_size(32)));

/// Values that a filter adds in pairs, at the same distance before and after the middle: along columns, those of
/// rows above and below.
struct RowPairs {
  const double* const* above;
  const double* const* below;
  const double* before(std::size_t i) const { return above[i]; }
  const double* after(std::size_t i) const { return below[i]; }
};

/// Along a row: the values i columns to the left and to the right.
struct ColumnPairs {
  const double* row;
  const double* before(std::size_t i) const { return row - i; }
  const double* after(std::size_t i) const { return row + i; }
};

template <class Value>
[[gnu::always_inline]] inline void read(Value& value, const double* from) {
  std::memcpy(&value, from, sizeof value);  // memcpy reads a value at any alignment
}

/// Computes out[x] = half[0] before(0)[x] + sum over i of half[i] (after(i)[x] ± before(i)[x]) for `count` Values
/// from x. `half` is a raw pointer, because checked indices make the loop a third slower. A Value holds one or
/// four consecutive x. Several Values share the reading of pointers and weights. Pairs are added before they are
/// multiplied: this halves the multiplications, and mirrored pictures get exactly mirrored sums.
template <class Value, int count, bool odd, class Pairs>
[[gnu::always_inline]] inline void addPairsAt(int x, const Pairs& pairs, const double* half, std::size_t weights,
                                              double* out) {
  constexpr int kStep = sizeof(Value) / sizeof(double);
  Value sum[count], b, a;
#pragma GCC unroll 8
  for (int k = 0; k < count; ++k) {
    read(b, pairs.before(0) + x + k * kStep);
    sum[k] = half[0] * b;
  }
  for (std::size_t i = 1; i < weights; ++i) {
    const double *before = pairs.before(i) + x, *after = pairs.after(i) + x;
    const double weight = half[i];
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k) {
      read(b, before + k * kStep);
      read(a, after + k * kStep);
      sum[k] += weight * (odd ? a - b : a + b);
    }
  }
#pragma GCC unroll 8
  for (int k = 0; k < count; ++k) std::memcpy(out + x + k * kStep, &sum[k], sizeof sum[k]);
}

template <bool odd, class Pairs>
[[gnu::always_inline]] inline void addPairsAlong(const Pairs& pairs, const std::vector<double>& half,
                                                 ColumnSpan where, double* out) {
  const double* const weights = half.data();
  const std::size_t count = half.size();
  int x = where.begin;
  for (; x + 16 <= where.end; x += 16) addPairsAt<Four, 4, odd>(x, pairs, weights, count, out);
  for (; x + 4 <= where.end; x += 4) addPairsAt<Four, 1, odd>(x, pairs, weights, count, out);
  for (; x < where.end; ++x) addPairsAt<double, 1, odd>(x, pairs, weights, count, out);
}

template <class Pairs>
[[gnu::always_inline]] inline void addPairs(Kernel::Parity parity, const Pairs& pairs,
                                            const std::vector<double>& half, ColumnSpan where, double* out) {
  if (parity == Kernel::Parity::kOdd)
    addPairsAlong<true>(pairs, half, where, out);
  else
    addPairsAlong<false>(pairs, half, where, out);
}

POINSOT_VECTORISED
void addRowPairs(Kernel::Parity parity, const RowPairs& pairs, const std::vector<double>& half, ColumnSpan where,
                 double* out) {
  addPairs(parity, pairs, half, where, out);
}

POINSOT_VECTORISED
void addColumnPairs(Kernel::Parity parity, const ColumnPairs& pairs, const std::vector<double>& half,
                    ColumnSpan where, double* out) {
  addPairs(parity, pairs, half, where, out);
}

}  // namespace

Kernel::Kernel(Parity parity, std::vector<double> half) : parity_(parity), half_(std::move(half)) {
  POINSOT_EXPECT(!half_.empty() && (parity == Parity::kEven || half_[0] == 0));
}

double Kernel::at(int offset) const {
  return half_.at(static_cast<std::size_t>(std::abs(offset))) * (offset < 0 ? sign() : 1);
}

double Kernel::sum() const {
  double total = half_[0];
  for (std::size_t i = 1; i < half_.size(); ++i) total += half_[i] * (1 + sign());
  return total;
}

Kernel Kernel::scaled(double factor) const {
  Kernel kernel = *this;
  for (double& weight : kernel.half_) weight *= factor;
  return kernel;
}

void Kernel::alongColumns(const RowWindow& window, int plane, ColumnSpan where, double* out) const {
  POINSOT_EXPECT(radius() <= window.radius());
  addRowPairs(parity_, {window.rowsAbove(plane), window.rowsBelow(plane)}, half_, where, out);
}

void Kernel::alongRow(const double* in, ColumnSpan where, double* out) const {
  addColumnPairs(parity_, {in}, half_, where, out);
}

RowWindow::RowWindow(image::PixelSize size, int planes, int radius, Source source)
    : size_(size), planes_(planes), radius_(radius), source_(std::move(source)) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0 && planes > 0 && radius >= 0);
  rows_.assign(static_cast<std::size_t>(planes * (2 * radius + 1)), MarginedRow(size.width, radius));
  pointers_.resize(static_cast<std::size_t>(planes * 2 * (radius + 1)));
}

double* RowWindow::slot(int plane, int y) {
  const int rows = 2 * radius_ + 1;
  return rows_[static_cast<std::size_t>(plane * rows + y % rows)].columns();
}

void RowWindow::make(int y) {
  std::vector<double*> rows(static_cast<std::size_t>(planes_));
  for (int k = 0; k < planes_; ++k) rows[static_cast<std::size_t>(k)] = slot(k, y);
  source_(y, rows);
  for (double* row : rows) {
    std::fill_n(row - radius_, radius_, row[0]);
    std::fill_n(row + size_.width, radius_, row[size_.width - 1]);
  }
}

void RowWindow::moveTo(int y) {
  POINSOT_EXPECT(y >= middle_ && y < size_.height);
  core::checkInterruption();  // polled here, because every filter calls moveTo() for each row
  middle_ = y;
  made_ = std::max(made_, y - radius_);
  for (; made_ <= std::min(y + radius_, size_.height - 1); ++made_) make(made_);
  pointToRows();
}

void RowWindow::pointToRows() {
  auto next = pointers_.begin();
  for (int plane = 0; plane < planes_; ++plane)
    for (const int step : {-1, 1})
      for (int i = 0; i <= radius_; ++i)
        *next++ = slot(plane, std::clamp(middle_ + step * i, 0, size_.height - 1));
}

}  // namespace poinsot::compare
