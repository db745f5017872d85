// SPDX-License-Identifier: Apache-2.0
#include "cli/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/expect.h"
#include "draw/color.h"
#include "render/text_painter.h"
#include "stage/palette.h"
#include "text/math_setter.h"

namespace poinsot::cli {
namespace {

constexpr image::PixelSize kCell{480, 270};
constexpr int kCellMargin = 40, kName = 60;    // px: margin around each picture; height of the name's band
constexpr float kType = 24, kBaseline = 0.48;  // text size in px; baseline as a fraction of the band
constexpr double kPaperTint = 0.06;            // part of ink in the paper, which makes white pictures visible
constexpr std::size_t kMostColumns = 5;

/// Weight of a source pixel in a pixel of the smaller picture.
struct Share {
  int from;
  double weight;
};

std::vector<std::vector<Share>> shares(int from, int to) {
  std::vector<std::vector<Share>> all(static_cast<std::size_t>(to));
  const double ratio = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double begin = i * ratio, end = (i + 1) * ratio;
    for (int k = static_cast<int>(begin); k < from && k < end; ++k) {
      const double covered = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
      if (covered > 0) all[static_cast<std::size_t>(i)].push_back({k, covered / ratio});
    }
  }
  return all;
}

draw::Color light(const image::Image& picture, int x, int y) {
  const std::uint8_t* pixel = picture.at(x, y);
  const float alpha = picture.channels == 4 ? static_cast<float>(pixel[3]) / 255 : 1;
  draw::Color color;
  for (int c = 0; c < 3; ++c) color[c] = alpha * draw::linearFromSrgb8(pixel[c]) + (1 - alpha);
  return color;
}

void put(image::Image& picture, int x, int y, const draw::Color& color) {
  for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = draw::srgb8FromLinear(color[c]);
}

image::PixelSize fitted(image::PixelSize size, image::PixelSize most) {
  const double factor = std::min(
      {1.0, static_cast<double>(most.width) / size.width, static_cast<double>(most.height) / size.height});
  const auto side = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(factor * pixels))); };
  return {side(size.width), side(size.height)};
}

struct Grid {
  int columns, rows;

  explicit Grid(std::size_t count)
      : columns(static_cast<int>(std::min(
            {count, kMostColumns, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))))}))),
        rows((static_cast<int>(count) + columns - 1) / columns) {}

  image::PixelSize size() const {
    return {columns * (kCell.width + kCellMargin) + kCellMargin, rows * (kCell.height + kName) + 2 * kCellMargin};
  }
  int left(int entry) const { return kCellMargin + entry % columns * (kCell.width + kCellMargin); }
  int top(int entry) const { return kCellMargin + entry / columns * (kCell.height + kName); }
};

void copyInto(image::Image& sheet, const image::Image& picture, int left, int top) {
  for (int y = 0; y < picture.size.height; ++y)
    std::memcpy(sheet.at(left, top + y), picture.at(0, y), picture.rowBytes());
}

std::string asTyped(const std::string& name) {
  std::string tex;
  for (const char c : name)
    tex +=
        std::string_view("$%&#_{}").find(c) == std::string_view::npos ? std::string(1, c) : std::string("\\") + c;
  return tex;
}

draw::Text nameUnder(const std::string& name, int left, int top, const draw::Color& ink) {
  const std::string tex = asTyped(name);
  const double width_em = std::max(text::setTex(tex).width_em, 1e-9);
  const float size_px = std::min(kType, static_cast<float>(kCell.width / width_em));
  const float centred = static_cast<float>(left) + 0.5f * (kCell.width - size_px * static_cast<float>(width_em));
  draw::Text text;
  text.tex = tex;
  text.baseline_px = {centred, static_cast<float>(top + kCell.height) + kBaseline * kName};
  text.size_px = size_px;
  text.color = ink;
  return text;
}

}  // namespace

image::Image shrunk(const image::Image& picture, image::PixelSize most) {
  image::Image small(fitted(picture.size, most), 3);
  const auto across = shares(picture.size.width, small.size.width);
  const auto down = shares(picture.size.height, small.size.height);
  for (int y = 0; y < small.size.height; ++y)
    for (int x = 0; x < small.size.width; ++x) {
      draw::Color sum(0);
      for (const Share& v : down[static_cast<std::size_t>(y)])
        for (const Share& h : across[static_cast<std::size_t>(x)])
          sum += static_cast<float>(v.weight * h.weight) * light(picture, h.from, v.from);
      put(small, x, y, sum);
    }
  return small;
}

image::Image contactSheet(const std::vector<SheetEntry>& entries) {
  POINSOT_EXPECT(!entries.empty());
  const stage::Palette colors = stage::palette(scene::Theme::kLight);
  const Grid grid(entries.size());
  image::Image sheet(grid.size(), 3);
  for (int y = 0; y < sheet.size.height; ++y)
    for (int x = 0; x < sheet.size.width; ++x)
      put(sheet, x, y, glm::mix(colors.paper, colors.ink, static_cast<float>(kPaperTint)));
  std::vector<draw::Text> names;
  for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
    const SheetEntry& entry = entries[static_cast<std::size_t>(i)];
    const image::Image small = shrunk(entry.picture, kCell);
    copyInto(sheet, small, grid.left(i) + (kCell.width - small.size.width) / 2,
             grid.top(i) + (kCell.height - small.size.height) / 2);
    names.push_back(nameUnder(entry.name, grid.left(i), grid.top(i), colors.ink));
  }
  render::TextPainter().paint(names, sheet);
  return sheet;
}

}  // namespace poinsot::cli
