// SPDX-License-Identifier: Apache-2.0
#include "render/cached_panel.h"

#include <algorithm>
#include <vector>

#include "gl/gl_includes.h"
#include "gl/storage.h"

namespace poinsot::render {
namespace {

template <typename Sample>
void dropAlpha(const Sample* rgba, std::size_t pixels, Sample* rgb) {
  for (std::size_t i = 0; i < pixels; ++i, rgba += 4, rgb += 3) {
    rgb[0] = rgba[0];
    rgb[1] = rgba[1];
    rgb[2] = rgba[2];
  }
}

int widthOf(const PixelBounds& part) { return static_cast<int>(part.right - part.left); }
int heightOf(const PixelBounds& part) { return static_cast<int>(part.bottom - part.top); }

template <typename Sample>
void readPart(const PixelBounds& part, std::vector<Sample>& rgba, image::BasicImage<Sample>& picture) {
  const int x = static_cast<int>(part.left), y = static_cast<int>(part.top), rows = heightOf(part);
  const auto width = static_cast<std::size_t>(widthOf(part));
  rgba.resize(4 * width * static_cast<std::size_t>(rows));
  glReadPixels(x, y, widthOf(part), rows, GL_RGBA, sizeof(Sample) == 1 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT,
               rgba.data());
  // glReadPixels may have allocated memory for a copy
  gl::expectStored("pixels to be read", rgba.size() * sizeof(Sample));
  for (int row = 0; row < rows; ++row) {
    const Sample* from = rgba.data() + 4 * width * static_cast<std::size_t>(row);
    if (picture.channels == 4)
      std::copy_n(from, 4 * width, picture.at(x, y + row));
    else
      dropAlpha(from, width, picture.at(x, y + row));
  }
}

template <typename Sample>
std::vector<Sample> paperRow(int width, const draw::Color& background, int channels) {
  std::vector<Sample> row(static_cast<std::size_t>(channels * width));
  for (std::size_t c = 0; c < 3; ++c) {
    const auto value = draw::srgbFromLinear<Sample>(background[static_cast<int>(c)]);
    for (std::size_t i = c; i < row.size(); i += static_cast<std::size_t>(channels)) row[i] = value;
  }
  return row;  // the alpha of each pixel, if present, is 0
}

}  // namespace

template <typename Sample>
TileCache& CachedPanel::begin(image::PixelSize size, bool transparent, Constants common) {
  const int channels = transparent ? 4 : 3;
  const auto* kept = std::get_if<image::BasicImage<Sample>>(&picture_);
  if (!kept || kept->size != size || kept->channels != channels) {
    tiles_ = {};
    picture_ = image::BasicImage<Sample>(size, channels);
  }
  changed_.clear();
  tiles_.beginPicture({size.width, size.height}, std::move(common));
  return tiles_;
}

template <typename Sample>
void CachedPanel::read(const Mosaic& mosaic, const draw::Color& background) {
  auto& picture = this->picture<Sample>();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  std::vector<Sample> rgba;
  for (const PixelBounds& part : mosaic.drawn) readPart(part, rgba, picture);
  for (const auto* parts : {&mosaic.drawn, &mosaic.paper})
    for (const PixelBounds& part : *parts) markChanged(part);
  layPaper<Sample>(mosaic.paper, background);
}

template <typename Sample>
void CachedPanel::layPaper(const std::vector<PixelBounds>& parts, const draw::Color& background) {
  if (parts.empty()) return;
  auto& picture = this->picture<Sample>();
  const auto row = paperRow<Sample>(picture.size.width, background, picture.channels);
  for (const PixelBounds& part : parts)
    for (int y = 0; y < heightOf(part); ++y)
      std::copy_n(row.data(), picture.channels * widthOf(part),
                  picture.at(static_cast<int>(part.left), static_cast<int>(part.top) + y));
}

void CachedPanel::forget(const std::vector<PixelBounds>& places) {
  for (const PixelBounds& place : places) {
    tiles_.forget(place);
    markChanged(place);
  }
}

void CachedPanel::markChanged(const PixelBounds& place) {
  const image::PixelSize size = std::visit([](const auto& picture) { return picture.size; }, picture_);
  const PixelBounds p = place.clipped({size.width, size.height});
  if (!p.empty())
    changed_.push_back({static_cast<int>(p.left), static_cast<int>(p.top), static_cast<int>(p.right),
                        static_cast<int>(p.bottom)});
}

template TileCache& CachedPanel::begin<std::uint8_t>(image::PixelSize, bool, Constants);
template TileCache& CachedPanel::begin<std::uint16_t>(image::PixelSize, bool, Constants);
template void CachedPanel::read<std::uint8_t>(const Mosaic&, const draw::Color&);
template void CachedPanel::read<std::uint16_t>(const Mosaic&, const draw::Color&);
template void CachedPanel::layPaper<std::uint8_t>(const std::vector<PixelBounds>&, const draw::Color&);
template void CachedPanel::layPaper<std::uint16_t>(const std::vector<PixelBounds>&, const draw::Color&);

}  // namespace poinsot::render
