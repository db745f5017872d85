// SPDX-License-Identifier: Apache-2.0
#include "compare/ignore_mask.h"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/expect.h"

namespace poinsot::compare {

IgnoreMask::IgnoreMask(image::PixelSize size) : size_(size) {
  POINSOT_EXPECT(size.width > 0 && size.height > 0);
  ignored_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
}

void IgnoreMask::add(const image::PixelRect& box) {
  for (int y = std::max(box.top, 0); y < std::min(box.bottom, size_.height); ++y)
    for (int x = std::max(box.left, 0); x < std::min(box.right, size_.width); ++x) ignore(x, y);
}

void IgnoreMask::add(const image::AnyImage& painted) {
  std::visit(
      [&](const auto& picture) {
        POINSOT_EXPECT(picture.size == size_);
        for (int y = 0; y < size_.height; ++y)
          for (int x = 0; x < size_.width; ++x) {
            const auto* p = picture.at(x, y);
            const bool seen = picture.channels == 3 || p[3] != 0;
            if (seen && (p[0] != 0 || p[1] != 0 || p[2] != 0)) ignore(x, y);
          }
      },
      painted);
}

bool IgnoreMask::ignores(int x, int y) const {
  POINSOT_EXPECT(x >= 0 && x < size_.width && y >= 0 && y < size_.height);
  return ignored_[index(x, y)] != 0;
}

std::vector<image::PixelRect> IgnoreMask::boxes(std::size_t most) const {
  std::vector<image::PixelRect> boxes;
  std::map<std::pair<int, int>, std::size_t> open;  // boxes that can still grow, by left and right edge
  for (int y = 0; y < size_.height; ++y) {
    std::map<std::pair<int, int>, std::size_t> now;
    for (int x = 0; x < size_.width; ++x) {
      if (!ignores(x, y)) continue;
      const int left = x;
      while (x < size_.width && ignores(x, y)) ++x;
      const auto above = open.find({left, x});
      if (above == open.end() && boxes.size() == most) continue;
      const std::size_t box = above == open.end() ? boxes.size() : above->second;
      if (above == open.end()) boxes.push_back({left, y, x, y});
      boxes[box].bottom = y + 1;
      now[{left, x}] = box;
    }
    open = std::move(now);
  }
  return boxes;
}

void IgnoreMask::ignore(int x, int y) {
  std::uint8_t& pixel = ignored_[index(x, y)];
  if (pixel == 0) ++count_;
  pixel = 1;
}

template <typename Sample>
image::BasicImage<Sample> withIgnoredOf(const image::BasicImage<Sample>& a, image::BasicImage<Sample> b,
                                        const IgnoreMask& ignored) {
  POINSOT_EXPECT(a.size == b.size && a.channels == b.channels && ignored.size() == a.size);
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x)
      if (ignored.ignores(x, y)) std::copy_n(a.at(x, y), a.channels, b.at(x, y));
  return b;
}

template image::Image withIgnoredOf(const image::Image& a, image::Image b, const IgnoreMask& ignored);
template image::DeepImage withIgnoredOf(const image::DeepImage& a, image::DeepImage b, const IgnoreMask& ignored);

image::AnyImage withIgnoredOf(const image::AnyImage& a, const image::AnyImage& b, const IgnoreMask& ignored) {
  POINSOT_EXPECT(a.index() == b.index());
  return std::visit(
      [&](const auto& first) -> image::AnyImage {
        return withIgnoredOf(first, std::get<std::decay_t<decltype(first)>>(b), ignored);
      },
      a);
}

}  // namespace poinsot::compare
