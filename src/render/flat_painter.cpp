// SPDX-License-Identifier: Apache-2.0
#include "render/flat_painter.h"

#include "render/blend.h"
#include "render/flat_coverage.h"

namespace poinsot::render {
namespace {

std::vector<float> numbers(const std::vector<glm::vec2>& points) {
  std::vector<float> all;
  all.reserve(2 * points.size());
  for (const glm::vec2& p : points) all.insert(all.end(), {p.x, p.y});
  return all;
}

}  // namespace

template <typename Sample>
PixelBounds FlatPainter::paint(const draw::Area& area, image::BasicImage<Sample>& picture) {
  const image::PixelSize size = picture.size;
  const auto make = [&] { return areaCoverage(area, {size.width, size.height}); };
  const auto& map = coverage_.get({size.width, size.height, numbers(area.points_px), 0.0f, 0.0f, true}, make);
  return blendCoverage(map, area.color, area.opacity, picture);
}

template <typename Sample>
PixelBounds FlatPainter::paint(const draw::Stroke& stroke, image::BasicImage<Sample>& picture) {
  if (stroke.width_px <= 0) return {};
  const image::PixelSize size = picture.size;
  const auto make = [&] { return strokeCoverage(stroke, {size.width, size.height}); };
  const auto& map = coverage_.get(
      {size.width, size.height, numbers(stroke.points_px), stroke.width_px, stroke.dash_px, stroke.closed}, make);
  return blendCoverage(map, stroke.color, stroke.opacity, picture);
}

template <typename Sample>
std::vector<PixelBounds> FlatPainter::paint(const draw::Picture& flat, image::BasicImage<Sample>& picture) {
  std::vector<PixelBounds> places;
  for (const draw::Area& area : flat.areas) places.push_back(paint(area, picture));
  for (const draw::Stroke& stroke : flat.strokes) places.push_back(paint(stroke, picture));
  return places;
}

template std::vector<PixelBounds> FlatPainter::paint(const draw::Picture&, image::Image&);
template std::vector<PixelBounds> FlatPainter::paint(const draw::Picture&, image::DeepImage&);

}  // namespace poinsot::render
