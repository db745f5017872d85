// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/picture.h"
#include "text/coverage.h"

namespace poinsot::render {

/// Returns the coverage of a stroke with round joins and ends: exact areas, rounded to bytes. Every dash ends
/// round, half the width beyond its length; a single point is a dot. Where a line overlaps itself within 64 pixels
/// of length, pixels that hold edges of both parts count twice.
/// @param size_px  size of the picture, to which the map is clipped
/// @pre points are finite
text::CoverageMap strokeCoverage(const draw::Stroke& stroke, glm::ivec2 size_px);

/// Returns the coverage of a polygon, closed from its last point to its first: exact areas, rounded to bytes.
/// Points with a winding number other than 0 are inside.
text::CoverageMap areaCoverage(const draw::Area& area, glm::ivec2 size_px);

}  // namespace poinsot::render
