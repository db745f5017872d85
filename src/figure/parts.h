// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "figure/visibility_lines.h"

namespace poinsot::figure {

/// The picture without flat curves, areas, strokes and type: what only an image can hold.
draw::Picture surfacesOf(const draw::Picture& picture);

/// The picture without its type, that of panels included; halos stay, so that there is room for it.
draw::Picture withoutType(const draw::Picture& picture);

/// The flat curves of one panel, to be painted in order over its surfaces and cut off at its edges.
struct PanelCurves {
  glm::ivec2 origin_px{0};
  glm::ivec2 size_px{0};
  std::vector<SeenLine> lines;  ///< from the panel's corner
};
std::vector<PanelCurves> curvesOf(const draw::Picture& picture);

/// All texts as they are read, titles first, placed from the picture's corner. None lies over another.
std::vector<draw::Text> labelsOf(const draw::Picture& picture);

}  // namespace poinsot::figure
