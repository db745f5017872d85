// SPDX-License-Identifier: Apache-2.0
#include "render/text_painter.h"

#include "render/blend.h"
#include "text/math_setter.h"

namespace poinsot::render {

const text::GlyphRun& TextPainter::run(const std::string& tex) {
  const auto known = runs_.find(tex);
  return known != runs_.end() ? known->second : runs_.emplace(tex, text::setTex(tex)).first->second;
}

const text::CoverageMap& TextPainter::coverage(const draw::Text& item, float outline_px) {
  const Key key{item.tex, item.size_px, item.baseline_px.x, item.baseline_px.y, outline_px};
  return coverage_.get(key, [&] {
    const auto size = static_cast<double>(item.size_px), outline = static_cast<double>(outline_px);
    const auto x = static_cast<double>(item.baseline_px.x), y = static_cast<double>(item.baseline_px.y);
    return text::rasterize(run(item.tex), size, x, y, outline);
  });
}

template <typename Sample>
PixelBounds TextPainter::paint(const draw::Text& item, image::BasicImage<Sample>& picture) {
  PixelBounds place;
  if (item.halo && item.halo_px > 0 && picture.channels == 4)
    place = eraseCoverage(coverage(item, item.halo_px), item.opacity, picture);
  else if (item.halo && item.halo_px > 0)
    place = blendCoverage(coverage(item, item.halo_px), *item.halo, item.opacity, picture);
  // A halo of the same colour covers the glyphs completely
  if (item.halo && item.halo_px > 0 && item.color == *item.halo) return place;
  place.include(blendCoverage(coverage(item, 0), item.color, item.opacity, picture));
  return place;
}

template <typename Sample>
std::vector<PixelBounds> TextPainter::paint(const std::vector<draw::Text>& texts,
                                            image::BasicImage<Sample>& picture) {
  std::vector<PixelBounds> places;
  for (const draw::Text& item : texts) places.push_back(paint(item, picture));
  return places;
}

template std::vector<PixelBounds> TextPainter::paint(const std::vector<draw::Text>&, image::Image&);
template std::vector<PixelBounds> TextPainter::paint(const std::vector<draw::Text>&, image::DeepImage&);

}  // namespace poinsot::render
