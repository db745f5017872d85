// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/picture.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Returns how much of each pixel a stroke covers: exact areas, rounded to bytes. Joins and ends are round. Each
/// dash is half a line width longer at both ends; a single point becomes a dot. If a line overlaps itself within
/// 64 pixels of length, pixels on edges of both parts count twice.
/// @param size_px  size of the picture, to which the map is clipped
/// @pre points are finite
text::CoverageMap strokeCoverage(const draw::Stroke& stroke, glm::ivec2 size_px);

/// Returns how much of each pixel a polygon covers: exact areas, rounded to bytes. The last point is joined to the
/// first. Points with a winding number other than 0 are inside.
text::CoverageMap areaCoverage(const draw::Area& area, glm::ivec2 size_px);

}  // namespace poinsot::render
