// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "stage/type/pixel_box.h"

namespace poinsot::stage {

/// A label that belongs to a point of the picture.
struct Label {
  std::string tex;
  glm::vec2 anchor_px{0};
  glm::vec2 direction{0, -1};  ///< from the anchor, where it would like to be; one shorter than 1 draws it nearer
  float gap_px = 0;            ///< between the anchor and the ink
  float size_px = 32;
  draw::Color color{0};
  float opacity = 1;
  float presence = 1;  ///< of one that comes or goes: so much it pushes others aside
};

/// The direction of `v`, shorter where that is not much longer than `soft`: so a label goes through its anchor,
/// where its direction turns about, and does not jump to the other side.
glm::vec2 softUnit(glm::vec2 v, float soft);

/// Places labels beside their anchors, apart from one another, inside the picture, and off the shafts of arrows
/// where there is room. A continuous function of the anchors, so that labels do not jump in a film, but where one
/// passes the middle of a box; those of points outside the picture fade. The picture's uppermost `top_px` stay
/// free, and so do the boxes in `taken`: a label in one gives way towards the picture's middle.
void addLabels(draw::DrawList& list, const std::vector<Label>& labels, const draw::Color& halo, float top_px = 0,
               std::span<const PixelBox> taken = {});

}  // namespace poinsot::stage
