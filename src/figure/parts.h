// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "figure/visibility_lines.h"

namespace poinsot::figure {

/// Returns the picture without flat curves, areas, strokes and type: the part that only an image can hold.
draw::Picture surfacesOf(const draw::Picture& picture);

/// Returns the picture without its type, also in panels. Halos stay, so that the type has room.
draw::Picture withoutType(const draw::Picture& picture);

/// Flat curves of one panel, with points from the panel's corner. They are painted in order over the panel's
/// surfaces and clipped at its edges.
struct PanelCurves {
  glm::ivec2 origin_px{0};
  glm::ivec2 size_px{0};
  std::vector<SeenLine> lines;
};
std::vector<PanelCurves> curvesOf(const draw::Picture& picture);

/// Returns all texts in reading order, titles first, placed from the picture's corner. No text lies over another.
std::vector<draw::Text> labelsOf(const draw::Picture& picture);

}  // namespace poinsot::figure
