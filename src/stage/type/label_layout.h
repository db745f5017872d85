// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
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

/// A straight thing in the picture that labels should not lie on: the shaft of an arrow.
struct LabelObstacle {
  glm::vec2 from_px{0}, to_px{0};
  float halfWidth_px = 0;
};

/// The straight round rods of a list, as its camera sees them; none that is not wholly in front of it.
std::vector<LabelObstacle> obstaclesOf(const draw::DrawList& list);

/// How far a box should move to leave the obstacle: across it, by what they overlap and `space_px`. Continuous in
/// all: a box whose middle the obstacle crosses does not move, and it moves less where it reaches beyond an end.
glm::vec2 pushOff(const LabelObstacle& obstacle, glm::vec2 centre_px, glm::vec2 half_px, float space_px);

}  // namespace poinsot::stage
