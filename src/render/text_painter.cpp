// SPDX-License-Identifier: Apache-2.0
#include "render/text_painter.h"

#include <algorithm>

#include "text/math_setter.h"

namespace poinsot::render {
namespace {

// One pixel: `share` of it is covered by `color`. A fourth channel is straight alpha.
void blend(std::uint8_t* pixel, int channels, const draw::Color& color, float share) {
  const float below = channels == 4 ? static_cast<float>(pixel[3]) / 255.0f : 1.0f;
  const float alpha = share + below * (1 - share);
  for (int c = 0; c < 3; ++c) {
    const float under = draw::linearFromSrgb8(pixel[c]);
    pixel[c] = draw::srgb8FromLinear((color[c] * share + under * below * (1 - share)) / alpha);
  }
  if (channels == 4) pixel[3] = static_cast<std::uint8_t>(alpha * 255.0f + 0.5f);
}

void blendCoverage(const text::CoverageMap& map, const draw::Color& color, float opacity, image::Image& picture) {
  const int right = std::min(map.left + map.width, picture.size.width);
  const int bottom = std::min(map.top + map.height, picture.size.height);
  for (int y = std::max(map.top, 0); y < bottom; ++y) {
    for (int x = std::max(map.left, 0); x < right; ++x) {
      const std::uint8_t coverage = map.at(x, y);
      if (coverage)
        blend(picture.at(x, y), picture.channels, color, opacity * static_cast<float>(coverage) / 255.0f);
    }
  }
}

}  // namespace

const text::GlyphRun& TextPainter::run(const std::string& tex) {
  const auto known = runs_.find(tex);
  return known != runs_.end() ? known->second : runs_.emplace(tex, text::setTex(tex)).first->second;
}

const text::CoverageMap& TextPainter::coverage(const draw::Text& item, float outline_px) {
  const Key key{item.tex, item.size_px, item.baseline_px.x, item.baseline_px.y, outline_px};
  if (const auto known = current_.find(key); known != current_.end()) return known->second;
  if (auto kept = last_.extract(key)) return current_.insert(std::move(kept)).position->second;
  const auto size = static_cast<double>(item.size_px), outline = static_cast<double>(outline_px);
  const auto x = static_cast<double>(item.baseline_px.x), y = static_cast<double>(item.baseline_px.y);
  return current_.emplace(key, text::rasterize(run(item.tex), size, x, y, outline)).first->second;
}

void TextPainter::paint(const draw::Text& item, image::Image& picture) {
  if (item.halo && item.halo_px > 0)
    blendCoverage(coverage(item, item.halo_px), *item.halo, item.opacity, picture);
  blendCoverage(coverage(item, 0), item.color, item.opacity, picture);
}

void TextPainter::paint(const std::vector<draw::Text>& texts, image::Image& picture) {
  std::swap(last_, current_);
  current_.clear();
  for (const draw::Text& item : texts) paint(item, picture);
}

}  // namespace poinsot::render
