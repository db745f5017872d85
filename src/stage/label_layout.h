// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::stage {

/// A label that belongs to a point of the picture.
struct Label {
  std::string tex;
  glm::vec2 anchor_px{0};
  glm::vec2 direction{0, -1};  ///< from the anchor, where the label would like to be; its length does not count
  float gap_px = 0;            ///< between the anchor and the ink
  float size_px = 32;
  draw::Color color{0};
  float opacity = 1;
};

/// Places labels beside their anchors, apart from one another and inside the picture. A continuous function of the
/// anchors, so that labels do not jump in a film. The picture's uppermost `top_px` stay free.
void addLabels(draw::DrawList& list, const std::vector<Label>& labels, const draw::Color& halo, float top_px = 0);

}  // namespace poinsot::stage
