// SPDX-License-Identifier: Apache-2.0
#include "output/ordered_dither.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/expect.h"

namespace poinsot::output {
namespace {

using Color = std::array<double, 3>;

// Approximate weights of red, green and blue in the visible difference of two colours.
constexpr Color kSeen{0.55, 0.77, 0.33};

// Cost of a coarse pattern, relative to the cost of a wrong colour. Mixing two distant colours looks coarser than
// mixing two similar colours.
constexpr double kCoarseness = 0.1;

constexpr int kSide = 8, kCells = kSide * kSide;

constexpr std::size_t placeOf(int x, int y) {
  return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
}

/// Bayer's matrix: the order in which the 64 pixels of the pattern change to the second colour.
constexpr std::array<std::uint8_t, kCells> kOrder = [] {
  std::array<std::uint8_t, kCells> order{};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      int value = 0;
      for (int bit = 0; bit < 3; ++bit) {
        const int a = (x >> bit) & 1, b = (y >> bit) & 1;
        value |= ((a ^ b) << (5 - 2 * bit)) | (b << (4 - 2 * bit));
      }
      order[placeOf(x, y)] = static_cast<std::uint8_t>(value);
    }
  return order;
}();

Color seen(const std::uint8_t* rgb) { return {kSeen[0] * rgb[0], kSeen[1] * rgb[1], kSeen[2] * rgb[2]}; }

Color minus(const Color& a, const Color& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Color& a, const Color& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::size_t indexOf(const std::uint8_t* rgb) {
  return static_cast<std::size_t>(rgb[0]) << 16 | static_cast<std::size_t>(rgb[1]) << 8 | rgb[2];
}

}  // namespace

OrderedDither::OrderedDither(std::vector<Rgb> palette)
    : palette_(std::move(palette)), mixes_(std::size_t{1} << 24) {
  POINSOT_EXPECT(!palette_.empty() && palette_.size() <= 256);
}

OrderedDither::Mix OrderedDither::mixOf(const std::uint8_t* rgb) const {
  const Color wanted = seen(rgb);
  const auto error = [&](const Rgb& color) {
    const Color off = minus(seen(color.data()), wanted);
    return dot(off, off);
  };
  const auto nearest = std::ranges::min_element(palette_, {}, error);
  Mix best{static_cast<std::uint8_t>(nearest - palette_.begin()), 0, 0, true};
  double least = error(*nearest);
  const Color first = seen(nearest->data()), missing = minus(wanted, first);
  for (std::size_t i = 0; i < palette_.size() && least > 0; ++i) {
    const Color step = minus(seen(palette_[i].data()), first);
    const double length2 = dot(step, step);
    if (length2 == 0) continue;
    // The nearest colour always fills at least half of the pattern.
    const double part = std::clamp(std::round(dot(missing, step) / length2 * kCells), 0.0, kCells / 2.0) / kCells;
    const Color off = {missing[0] - part * step[0], missing[1] - part * step[1], missing[2] - part * step[2]};
    const double cost = dot(off, off) + kCoarseness * part * (1 - part) * length2;
    if (cost >= least) continue;
    least = cost;
    best.second = static_cast<std::uint8_t>(i);
    best.share = static_cast<std::uint8_t>(part * kCells);
  }
  return best;
}

void OrderedDither::apply(const image::Image& picture, std::span<std::uint8_t> indices, std::ptrdiff_t stride) {
  POINSOT_EXPECT(stride >= picture.size.width && std::ssize(indices) >= stride * picture.size.height);
  for (int y = 0; y < picture.size.height; ++y) {
    const std::uint8_t* from = picture.at(0, y);
    std::uint8_t* to = indices.data() + y * stride;
    for (int x = 0; x < picture.size.width; ++x, from += picture.channels) {
      Mix& mix = mixes_[indexOf(from)];
      if (!mix.known) mix = mixOf(from);
      const bool second = kOrder[placeOf(x % kSide, y % kSide)] < mix.share;
      to[x] = second ? mix.second : mix.first;
    }
  }
}

}  // namespace poinsot::output
