// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/constants.h"
#include "render/sheets.h"

/// Functions that append the constants of one sheet, in the order in which sheet_*.glsl reads them.
namespace poinsot::render {

inline constexpr std::size_t kEllipsoidConstants = 12, kPlaneConstants = 10, kConeConstants = 9;
constexpr std::size_t polygonConstants(std::size_t sides) { return 5 + sides + (sides + 3) / 4; }

void append(Constants& to, const draw::GlassEllipsoid& ellipsoid, const EllipsoidSheet& sheet);
/// @param shadow  whether the plane's shadow is drawn
void append(Constants& to, const draw::GridPlane& plane, const PlaneSheet& sheet, bool shadow);
void append(Constants& to, const draw::GlassCone& cone, const ConeSheet& sheet);
/// @param sides  number of sides for which the program is compiled
void append(Constants& to, const draw::GlassPolygon& polygon, const PolygonSheet& sheet, std::size_t sides);

}  // namespace poinsot::render
