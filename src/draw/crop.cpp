// SPDX-License-Identifier: Apache-2.0
#include "draw/crop.h"

#include <glm/common.hpp>
#include <utility>

#include "core/expect.h"

namespace poinsot::draw {
namespace {

void move(std::vector<glm::vec2>& points_px, glm::vec2 by_px) {
  for (glm::vec2& point_px : points_px) point_px += by_px;
}

void move(std::vector<Text>& texts, glm::vec2 by_px) {
  for (Text& text : texts) text.baseline_px += by_px;
}

/// Cuts a panel to a rectangle of the picture. The optical axis moves, and the number of pixels per length stays.
Panel cropped(Panel panel, glm::ivec2 low_px, glm::ivec2 high_px) {
  Camera& camera = panel.list.camera;
  const glm::vec2 by_px(panel.origin_px - low_px);
  const float share = static_cast<float>(high_px.y - low_px.y) / camera.size_px.y;
  camera.tanHalfFovY *= share;
  camera.halfHeight_V *= share;
  camera.centre_px += by_px;
  camera.size_px = glm::vec2(high_px - low_px);
  move(panel.list.texts, by_px);
  panel.origin_px = low_px;
  return panel;
}

}  // namespace

Picture cropped(const Picture& picture, glm::ivec2 origin_px, glm::ivec2 size_px) {
  POINSOT_EXPECT(size_px.x > 0 && size_px.y > 0 && origin_px.x >= 0 && origin_px.y >= 0);
  POINSOT_EXPECT(origin_px.x + size_px.x <= picture.size_px.x && origin_px.y + size_px.y <= picture.size_px.y);
  Picture part = picture;
  part.size_px = size_px;
  part.panels.clear();
  for (const Panel& panel : picture.panels) {
    const glm::ivec2 low_px = glm::max(panel.origin_px, origin_px);
    const glm::ivec2 high_px =
        glm::min(panel.origin_px + glm::ivec2(panel.list.camera.size_px), origin_px + size_px);
    if (low_px.x >= high_px.x || low_px.y >= high_px.y) continue;
    part.panels.push_back(cropped(panel, low_px, high_px));
    part.panels.back().origin_px -= origin_px;
  }
  const glm::vec2 by_px(-origin_px);
  for (Area& area : part.areas) move(area.points_px, by_px);
  for (Stroke& stroke : part.strokes) move(stroke.points_px, by_px);
  move(part.texts, by_px);
  return part;
}

}  // namespace poinsot::draw
