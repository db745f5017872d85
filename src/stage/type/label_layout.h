// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "stage/type/pixel_box.h"

namespace poinsot::stage {

struct Label {
  std::string tex;
  glm::vec2 anchor_px{0};
  glm::vec2 direction{0, -1};  ///< preferred direction from the anchor; a shorter vector brings the label nearer
  float gap_px = 0;
  float size_px = 32;
  draw::Color color{0};
  float opacity = 1;
  float presence = 1;  ///< strength with which the label pushes others aside; less than 1 while it appears
};

/// Returns a vector in the direction of `v`, at most 1 long. The vector is short if `v` is not much longer than
/// `soft`. A label whose direction reverses therefore moves through its anchor instead of jumping to the other
/// side.
glm::vec2 softUnit(glm::vec2 v, float soft);

/// Places labels beside their anchors. Labels stay apart from one another, inside the picture and, if there is
/// room, off the shafts of arrows. Their positions are continuous functions of the anchors, so labels do not jump
/// in a film, except when a label passes the middle of a box. Labels of points outside the picture fade.
/// @param top_px  height at the top that stays free
/// @param taken  boxes that stay free; a label in a box moves towards the picture's middle
void addLabels(draw::DrawList& list, const std::vector<Label>& labels, const draw::Color& halo, float top_px = 0,
               std::span<const PixelBox> taken = {});

/// Straight object that labels avoid, such as the shaft of an arrow.
struct LabelObstacle {
  glm::vec2 from_px{0}, to_px{0};
  float halfWidth_px = 0;
};

/// Returns the straight round rods of a draw list, as its camera sees them. Rods that are not completely in front
/// of the camera are left out.
std::vector<LabelObstacle> obstaclesOf(const draw::DrawList& list);

/// Returns the shift that moves a box away from an obstacle. The shift is perpendicular to the obstacle, and its
/// length is their overlap plus `space_px`. The shift is continuous in all arguments: a box centred on the
/// obstacle does not move, and a box beyond an end moves less.
glm::vec2 pushOff(const LabelObstacle& obstacle, glm::vec2 centre_px, glm::vec2 half_px, float space_px);

}  // namespace poinsot::stage
