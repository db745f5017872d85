// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::draw {

// ---- flat objects: over the panels, in list order; pixels from the top left corner, y down ----------------

/// Line of constant width with round joins. Dashes and gaps have the length `dash_px`; 0 is unbroken.
struct Stroke {
  std::vector<glm::vec2> points_px;
  bool closed = false;
  float width_px = 2;
  float dash_px = 0;
  Color color{0};
  float opacity = 1;
  int plot = 0;  ///< number of the plot that the line belongs to, from 1; 0 if none; does not change the picture
};

struct Area {
  std::vector<glm::vec2> points_px;
  Color color{0};
  float opacity = 1;
};

/// View of a three-dimensional scene. Its top left corner is at `origin_px` of the picture. Positions of the
/// list's texts are measured from this corner.
/// @pre the list's camera is made for the panel's size.
struct Panel {
  glm::ivec2 origin_px{0};
  DrawList list;
};

/// Complete picture as plain values, from which images and figures are made. Areas are drawn over the panels,
/// strokes over the areas, and texts over everything.
struct Picture {
  glm::ivec2 size_px{1, 1};
  Color background{1};
  std::vector<Panel> panels;  ///< panels must not overlap
  std::vector<Area> areas;
  std::vector<Stroke> strokes;
  std::vector<Text> texts;
};

}  // namespace poinsot::draw
