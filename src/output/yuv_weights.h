// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Integer weights with which bytes of R, G and B are converted to BT.709, limited range.
namespace poinsot::output {

struct Weights {
  std::int32_t r = 0;
  std::int32_t g = 0;
  std::int32_t b = 0;
};

constexpr std::int32_t nearestInteger(double v) { return static_cast<std::int32_t>(v < 0 ? v - 0.5 : v + 0.5); }

/// Returns the weights for luma. Green gets the remainder of the total, so that greys are exact: black is 16,
/// white is 235, and no grey has a hue.
constexpr Weights lumaWeights(double scale) {
  const double range = 219.0 / 255 * scale;
  const Weights w = {nearestInteger(0.2126 * range), 0, nearestInteger(0.0722 * range)};
  return {w.r, nearestInteger(range) - w.r - w.b, w.b};
}

constexpr Weights cbWeights(double scale) {
  const double range = 224.0 / 255 * scale;
  const std::int32_t r = nearestInteger(-0.2126 / 1.8556 * range), b = nearestInteger(0.5 * range);
  return {r, -r - b, b};
}

constexpr Weights crWeights(double scale) {
  const double range = 224.0 / 255 * scale;
  const std::int32_t r = nearestInteger(0.5 * range), b = nearestInteger(-0.0722 / 1.5748 * range);
  return {r, -r - b, b};
}

}  // namespace poinsot::output
