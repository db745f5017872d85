// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "draw/picture.h"

namespace poinsot::figure {

/// Point of a picture with its name in a figure for LaTeX, such as "poinsot-L".
struct PlacedPoint {
  std::string name;
  glm::dvec2 at_px{0};  ///< from the picture's top left corner, y down
};

/// Returns the named points of all panels, in drawing order. Each has a name of its own: equal names of a panel
/// get the endings -2, -3 and so on. If there are several panels, names begin with the panel's number, as in
/// "poinsot-2-L". Points of the first panel then have two names, with and without the number.
/// Leaves out points behind the camera, and points so far outside the picture that TeX cannot place them.
/// @param pointsPerPixel  length of a pixel's side in points of 1/72 inch
std::vector<PlacedPoint> placedPoints(const draw::Picture& picture, double pointsPerPixel);

}  // namespace poinsot::figure
