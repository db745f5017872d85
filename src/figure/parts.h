// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "figure/visibility_lines.h"

namespace poinsot::figure {

/// Returns the surfaces of a picture: the picture without flat curves, areas, strokes and text.
draw::Picture surfacesOf(const draw::Picture& picture);

/// Returns the picture without text in the picture and its panels. Halos stay, to keep space for the text.
draw::Picture withoutType(const draw::Picture& picture);

/// Flat curves of one panel. Points are measured from the panel's top left corner. Curves are painted over the
/// panel's surfaces in the order of the list, and clipped to the panel.
struct PanelCurves {
  glm::ivec2 origin_px{0};
  glm::ivec2 size_px{0};
  std::vector<SeenLine> lines;
};
std::vector<PanelCurves> curvesOf(const draw::Picture& picture);

/// Returns all texts of the picture and its panels in reading order, titles first. Positions are measured from the
/// picture's corner. Texts do not overlap.
std::vector<draw::Text> labelsOf(const draw::Picture& picture);

}  // namespace poinsot::figure
