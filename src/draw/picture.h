// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "draw/draw_list.h"

namespace poinsot::draw {

// ---- flat things: over the panels, in the order of the list; pixels from the top left corner, y down
// -------------

/// A line of constant width with round joins; `dash_px` on, as much off, 0 is unbroken.
struct Stroke {
  std::vector<glm::vec2> points_px;
  bool closed = false;
  float width_px = 2;
  float dash_px = 0;
  Color color{0};
  float opacity = 1;
};

/// A filled polygon.
struct Area {
  std::vector<glm::vec2> points_px;
  Color color{0};
  float opacity = 1;
};

/// A view in space, somewhere in the picture. @pre the list's camera is made for the panel's size.
struct Panel {
  glm::ivec2 origin_px{0};  ///< its top left corner
  DrawList list;            ///< its texts are placed from the panel's corner
};

/// A whole picture, as plain values: what every output medium reads.
struct Picture {
  glm::ivec2 size_px{1, 1};
  Color background{1};
  std::vector<Panel> panels;  ///< do not overlap
  std::vector<Area> areas;
  std::vector<Stroke> strokes;  ///< over the areas
  std::vector<Text> texts;      ///< over all
};

}  // namespace poinsot::draw
