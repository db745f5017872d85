// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::stage {

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
