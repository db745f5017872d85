// SPDX-License-Identifier: Apache-2.0
#include "draw/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace poinsot::draw {
namespace {

double decode(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double encode(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

template <std::size_t count>
std::array<float, count> makeDecodeTable() {
  std::array<float, count> table{};
  for (std::size_t v = 0; v < count; ++v)
    table[v] = static_cast<float>(decode(static_cast<double>(v) / (count - 1)));
  return table;
}

// Returns the thresholds of the 8-bit encoding: light at or above threshold v is encoded as v + 1 or more.
std::array<float, 255> makeThresholds() {
  std::array<float, 255> table{};
  for (std::size_t v = 0; v < table.size(); ++v)
    table[v] = static_cast<float>(decode((static_cast<double>(v) + 0.5) / 255));
  return table;
}

// Size of a table with the first 8-bit value to try, for equal parts of [0, 1). The value that is searched is at
// most two steps above it.
constexpr std::size_t kStarts = 4096;

std::array<std::uint8_t, kStarts> makeStarts(const std::array<float, 255>& thresholds) {
  std::array<std::uint8_t, kStarts> table{};
  for (std::size_t i = 0; i < kStarts; ++i) {
    const auto above = std::ranges::upper_bound(thresholds, static_cast<float>(i) / kStarts);
    table[i] = static_cast<std::uint8_t>(above - thresholds.begin());
  }
  return table;
}

}  // namespace

float linearFromSrgb8(std::uint8_t value) {
  static const auto table = makeDecodeTable<256>();
  return table[value];
}

std::uint8_t srgb8FromLinear(float linear) {
  static const auto thresholds = makeThresholds();
  static const auto starts = makeStarts(thresholds);
  if (!(linear > 0)) return 0;
  if (linear >= thresholds.back()) return 255;
  std::size_t v = starts[static_cast<std::size_t>(linear * kStarts)];
  while (linear >= thresholds[v]) ++v;
  return static_cast<std::uint8_t>(v);
}

float linearFromSrgb16(std::uint16_t value) {
  static const auto table = makeDecodeTable<65536>();
  return table[value];
}

std::uint16_t srgb16FromLinear(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 65535;
  return static_cast<std::uint16_t>(std::lround(65535 * encode(static_cast<double>(linear))));
}

Color fromSrgb(std::uint32_t hex) {
  const auto channel = [hex](int shift) {
    return linearFromSrgb8(static_cast<std::uint8_t>(hex >> shift & 0xff));
  };
  return {channel(16), channel(8), channel(0)};
}

}  // namespace poinsot::draw
