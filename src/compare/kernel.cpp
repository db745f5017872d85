// SPDX-License-Identifier: Apache-2.0
#include "compare/kernel.h"

#include <algorithm>
#include <cstring>

#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {

namespace {

typedef double Four __attribute__((vector_size(32)));

/// Row pointers for the offsets 0, 1, ..., radius on one side of the middle. A filter along a row has all of them
/// point into that row.
using Rows = std::vector<const double*>;

/// Weights and rows for the innermost loop. They are raw pointers, because checked indices make the loop a third
/// slower.
struct Pairs {
  const double* half;
  const double* const* before;
  const double* const* after;
  std::size_t count;
};

/// Computes out[x] = half[0] before[0][x] + sum over i of half[i] (after[i][x] ± before[i][x]). A Value holds one
/// or four consecutive x. Pairs are added before they are multiplied: this halves the multiplications, and
/// mirrored pictures get exactly mirrored sums.
template <class Value, bool odd>
[[gnu::always_inline]] inline void addPairsAt(int x, const Pairs& pairs, double* out) {
  Value sum, b, a;
  std::memcpy(&b, pairs.before[0] + x, sizeof b);  // memcpy reads a value at any alignment
  sum = pairs.half[0] * b;
  for (std::size_t i = 1; i < pairs.count; ++i) {
    std::memcpy(&b, pairs.before[i] + x, sizeof b);
    std::memcpy(&a, pairs.after[i] + x, sizeof a);
    sum += pairs.half[i] * (odd ? a - b : a + b);
  }
  std::memcpy(out + x, &sum, sizeof sum);
}

template <bool odd>
[[gnu::always_inline]] inline void addPairsAlong(const Pairs& pairs, ColumnSpan where, double* out) {
  int x = where.begin;
  for (; x + 4 <= where.end; x += 4) addPairsAt<Four, odd>(x, pairs, out);
  for (; x < where.end; ++x) addPairsAt<double, odd>(x, pairs, out);
}

// The compiler makes two versions of this function. The AVX2 version computes the same sums, four values per
// instruction; it has no FMA, which would round differently. Builds for ThreadSanitizer have one version, because
// selecting a version before ThreadSanitizer is ready would end the program.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
[[gnu::target_clones("avx2", "default")]]
#endif
void addPairs(bool odd, const Pairs& pairs, ColumnSpan where, double* out) {
  if (odd)
    addPairsAlong<true>(pairs, where, out);
  else
    addPairsAlong<false>(pairs, where, out);
}

Pairs pairsOf(const std::vector<double>& half, const Rows& before, const Rows& after) {
  POINSOT_EXPECT(before.size() == half.size() && after.size() == half.size());
  return {half.data(), before.data(), after.data(), half.size()};
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
  Rows before(half_.size()), after(half_.size());
  for (int i = 0; i <= radius(); ++i) {
    before[static_cast<std::size_t>(i)] = window.row(plane, -i);
    after[static_cast<std::size_t>(i)] = window.row(plane, i);
  }
  addPairs(parity_ == Parity::kOdd, pairsOf(half_, before, after), where, out);
}

void Kernel::alongRow(const double* in, ColumnSpan where, double* out) const {
  Rows before(half_.size()), after(half_.size());
  for (int i = 0; i <= radius(); ++i) {
    before[static_cast<std::size_t>(i)] = in - i;
    after[static_cast<std::size_t>(i)] = in + i;
  }
  addPairs(parity_ == Parity::kOdd, pairsOf(half_, before, after), where, out);
}

RowWindow::RowWindow(image::PixelSize size, int planes, int radius, Source source)
    : size_(size), planes_(planes), radius_(radius), source_(std::move(source)) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0 && planes > 0 && radius >= 0);
  rows_.assign(static_cast<std::size_t>(planes * (2 * radius + 1)), MarginedRow(size.width, radius));
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
}

const double* RowWindow::row(int plane, int offset) const {
  const int y = std::clamp(middle_ + offset, 0, size_.height - 1);
  return const_cast<RowWindow*>(this)->slot(plane, y);
}

}  // namespace poinsot::compare
