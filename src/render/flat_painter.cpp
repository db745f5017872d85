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

void FlatPainter::paint(const draw::Area& area, image::Image& picture) {
  const auto [width, height] = picture.size;
  const auto make = [&] { return areaCoverage(area, {width, height}); };
  const auto& map = coverage_.get({width, height, numbers(area.points_px), 0.0f, 0.0f, true}, make);
  blendCoverage(map, area.color, area.opacity, picture);
}

void FlatPainter::paint(const draw::Stroke& stroke, image::Image& picture) {
  if (stroke.width_px <= 0) return;
  const auto [width, height] = picture.size;
  const auto make = [&] { return strokeCoverage(stroke, {width, height}); };
  const auto& map = coverage_.get(
      {width, height, numbers(stroke.points_px), stroke.width_px, stroke.dash_px, stroke.closed}, make);
  blendCoverage(map, stroke.color, stroke.opacity, picture);
}

void FlatPainter::paint(const draw::Picture& flat, image::Image& picture) {
  for (const draw::Area& area : flat.areas) paint(area, picture);
  for (const draw::Stroke& stroke : flat.strokes) paint(stroke, picture);
}

}  // namespace poinsot::render
