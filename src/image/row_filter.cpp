// SPDX-License-Identifier: Apache-2.0
#include "image/row_filter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/expect.h"

namespace poinsot::image {
namespace {

enum FilterNumber : std::uint8_t { kSub = 1, kUp = 2, kPaeth = 4 };

// Number of bytes that are compared at once. Most of a picture is background, where all pixels are equal and need
// no filter.
constexpr std::size_t kChunk = 192;

/// Returns one of three neighbouring pixels: the one nearest to left + above - corner (Paeth).
std::uint8_t paethPredictor(std::int16_t left, std::int16_t above, std::int16_t corner) {
  // All arithmetic has 16 bits, because a CPU register then contains twice as many values as with 32 bits.
  const auto fromLeft = static_cast<std::int16_t>(std::abs(above - corner));
  const auto fromAbove = static_cast<std::int16_t>(std::abs(left - corner));
  const auto fromCorner = static_cast<std::int16_t>(std::abs(left + above - 2 * corner));
  const std::int16_t nearer = fromAbove <= fromCorner ? above : corner;
  return static_cast<std::uint8_t>(fromLeft <= std::min(fromAbove, fromCorner) ? left : nearer);
}

/// Writes the bytes filter(0), filter(1), ..., filter(size - 1). Returns how many of them are not 0.
template <typename Filter>
std::size_t write(std::size_t size, std::uint8_t* to, const Filter& filter) {
  for (std::size_t i = 0; i < size; ++i) to[i] = filter(i);
  return size - static_cast<std::size_t>(std::count(to, to + size, 0));
}

}  // namespace

RowFilter::RowFilter(std::size_t rowBytes, std::size_t pixelBytes)
    : rowBytes_(rowBytes), pixelBytes_(pixelBytes), row_(pixelBytes + rowBytes), above_(row_) {
  POINSOT_EXPECT(rowBytes > 0 && pixelBytes > 0);
  flat_.resize((rowBytes + kChunk - 1) / kChunk, 1);
  flatAbove_ = flat_;
  for (const auto& [candidate, number] : {std::pair(&sub_, kSub), {&up_, kUp}, {&paeth_, kPaeth}}) {
    candidate->bytes.resize(1 + rowBytes);
    candidate->bytes[0] = number;
  }
}

std::uint8_t* RowFilter::next() {
  std::swap(row_, above_);
  std::swap(flat_, flatAbove_);
  return row_.data() + pixelBytes_;
}

std::span<const std::uint8_t> RowFilter::filtered() {
  for (Candidate* candidate : {&sub_, &up_, &paeth_}) candidate->others = 0;
  for (std::size_t begin = 0; begin < rowBytes_; begin += kChunk)
    filterChunk(begin, std::min(kChunk, rowBytes_ - begin));
  return std::min({&sub_, &up_, &paeth_}, [](auto* a, auto* b) { return a->others < b->others; })->bytes;
}

void RowFilter::filterChunk(std::size_t begin, std::size_t size) {
  const std::uint8_t *left = row_.data() + begin, *row = left + pixelBytes_;
  const std::uint8_t *corner = above_.data() + begin, *above = corner + pixelBytes_;
  std::uint8_t *sub = sub_.bytes.data() + 1 + begin, *up = up_.bytes.data() + 1 + begin,
               *paeth = paeth_.bytes.data() + 1 + begin;
  char& flat = flat_[begin / kChunk];
  flat = std::memcmp(left, row, size) == 0 ? 1 : 0;
  if (std::memcmp(row, above, size) == 0)
    std::fill_n(up, size, 0);
  else
    up_.others += write(size, up, [&](std::size_t i) { return static_cast<std::uint8_t>(row[i] - above[i]); });
  // If all pixels are equal in both rows, the prediction is the pixel to the left.
  if (flat != 0 && flatAbove_[begin / kChunk] != 0) {
    std::fill_n(sub, size, 0);
    std::fill_n(paeth, size, 0);
    return;
  }
  sub_.others += write(size, sub, [&](std::size_t i) { return static_cast<std::uint8_t>(row[i] - left[i]); });
  paeth_.others += write(size, paeth, [&](std::size_t i) {
    return static_cast<std::uint8_t>(row[i] - paethPredictor(left[i], above[i], corner[i]));
  });
}

}  // namespace poinsot::image
