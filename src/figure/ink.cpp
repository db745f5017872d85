// SPDX-License-Identifier: Apache-2.0
#include "figure/ink.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::figure {
namespace {

// Returns an encoded value, rounded to 8 bits like all other colours of a figure.
double encoded(float linear) { return draw::srgb8FromLinear(linear) / 255.0; }

}  // namespace

Ink inkOver(const draw::Color& paper, const draw::Color& color, float opacity) {
  Ink ink;
  ink.alpha = static_cast<double>(opacity);
  double under[3], wanted[3];
  for (int c = 0; c < 3; ++c) {
    under[c] = encoded(paper[c]);
    wanted[c] = opacity < 1 ? encoded(opacity * color[c] + (1 - opacity) * paper[c]) : encoded(color[c]);
    // Raises alpha until wanted = (1 - alpha) under + alpha ink has a solution with ink in [0, 1].
    const double room = wanted[c] > under[c] ? 1 - under[c] : under[c];
    if (room > 0) ink.alpha = std::max(ink.alpha, std::abs(wanted[c] - under[c]) / room);
  }
  for (int c = 0; c < 3; ++c)
    ink.srgb[c] = ink.alpha > 0 ? std::clamp(under[c] + (wanted[c] - under[c]) / ink.alpha, 0.0, 1.0) : 0;
  return ink;
}

std::string hexOf(const Ink& ink) {
  const auto byte = [](double v) { return static_cast<int>(std::lround(255 * v)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(ink.srgb.r), byte(ink.srgb.g), byte(ink.srgb.b));
}

}  // namespace poinsot::figure
