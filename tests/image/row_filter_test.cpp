// SPDX-License-Identifier: Apache-2.0
// Expected: the specification's inverse of a filter (PNG, third edition, clause 9), written out here for the bytes
// of a row.
#include "image/row_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

namespace poinsot::image {
namespace {

using Row = std::vector<std::uint8_t>;

int paeth(int a, int b, int c) {
  const int p = a + b - c;
  if (std::abs(p - a) <= std::abs(p - b) && std::abs(p - a) <= std::abs(p - c)) return a;
  return std::abs(p - b) <= std::abs(p - c) ? b : c;
}

/// Returns the row that `filtered` encodes, below `above`.
Row unfiltered(const Row& filtered, const Row& above, std::size_t pixelBytes) {
  Row row(filtered.begin() + 1, filtered.end());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool first = i < pixelBytes;
    const int a = first ? 0 : row[i - pixelBytes], b = above[i], c = first ? 0 : above[i - pixelBytes];
    const int added[] = {0, a, b, (a + b) / 2, paeth(a, b, c)};
    row[i] = static_cast<std::uint8_t>(row[i] + added[filtered[0]]);
  }
  return row;
}

Row filteredBy(RowFilter& filter, const Row& row) {
  std::ranges::copy(row, filter.next());
  const auto filtered = filter.filtered();
  return {filtered.begin(), filtered.end()};
}

/// Returns rows of random stretches, which are flat, repeat the row above, rise, or are noise.
std::vector<Row> patchwork(std::size_t rowBytes, std::size_t pixelBytes, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Row> rows(1, Row(rowBytes));
  while (std::ssize(rows) <= count) {
    Row row = rows.back();
    for (std::size_t i = 0; i < rowBytes;) {
      const auto kind = random() % 4;
      const auto step = static_cast<std::uint8_t>(random() % 5);
      for (const std::size_t end = std::min(rowBytes, i + 1 + random() % 500); i < end; ++i) {
        const std::uint8_t left = i < pixelBytes ? std::uint8_t{0} : row[i - pixelBytes];
        if (kind == 0) row[i] = left;
        if (kind == 1) row[i] = static_cast<std::uint8_t>(left + step);
        if (kind == 2) row[i] = static_cast<std::uint8_t>(random());
      }
    }
    rows.push_back(row);
  }
  return rows;  // the first is what lies above the picture
}

TEST(RowFilter, IsUndoneByTheSpecifiedInverse) {
  for (const std::size_t pixelBytes : {3, 4, 6, 8})
    for (const std::size_t width : {1, 2, 23, 24, 48, 64, 65, 997}) {
      const auto rows = patchwork(width * pixelBytes, pixelBytes, 40, static_cast<unsigned>(width));
      RowFilter filter(width * pixelBytes, pixelBytes);
      for (std::size_t y = 1; y < rows.size(); ++y)
        ASSERT_EQ(unfiltered(filteredBy(filter, rows[y]), rows[y - 1], pixelBytes), rows[y])
            << width << " pixels of " << pixelBytes << " bytes, row " << y;
    }
}

Row flat(std::uint8_t value) { return Row(600, value); }

Row noisy(unsigned seed) {
  std::mt19937 random(seed);
  Row row(600);
  for (auto& byte : row) byte = static_cast<std::uint8_t>(random());
  return row;
}

Row joined(const Row& left, const Row& right) {
  Row row = left;
  std::copy(right.begin() + 300, right.end(), row.begin() + 300);
  return row;
}

std::size_t others(const Row& filtered) {
  return filtered.size() - 1 - static_cast<std::size_t>(std::count(filtered.begin() + 1, filtered.end(), 0));
}

TEST(RowFilter, PicksTheFilterThatLeavesTheFewestNonzeroBytes) {
  struct Case {
    const char* what;
    Row above, row;
    int filter;
    std::size_t others;
  };
  const Case cases[] = {
      {"paper below paper", flat(255), flat(255), 2, 0},
      {"paper below noise", noisy(1), flat(255), 1, 3},
      {"noise again", noisy(1), noisy(1), 2, 0},
      {"now as on the left, now as above", joined(flat(100), noisy(1)), joined(flat(101), noisy(1)), 4, 3},
  };
  for (const Case& c : cases) {
    RowFilter filter(600, 3);
    filteredBy(filter, c.above);
    const Row filtered = filteredBy(filter, c.row);
    EXPECT_EQ(filtered[0], c.filter) << c.what;
    EXPECT_EQ(others(filtered), c.others) << c.what;
  }
}

}  // namespace
}  // namespace poinsot::image
