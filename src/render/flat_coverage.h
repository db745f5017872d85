// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/picture.h"
#include "text/coverage.h"

/// How much of each pixel flat things cover: exact areas, rounded to bytes.
namespace poinsot::render {

/// A stroke with round joins and ends: every dash ends round, half the width beyond its length. A single point is
/// a dot. Within 64 pixels along the line, what lies on itself counts twice in pixels that hold edges of both.
/// @param size_px  of the picture, which the map is cut to
/// @pre points are finite
text::CoverageMap strokeCoverage(const draw::Stroke& stroke, glm::ivec2 size_px);

/// A polygon, its last point joined to its first; inside is where it winds about.
text::CoverageMap areaCoverage(const draw::Area& area, glm::ivec2 size_px);

}  // namespace poinsot::render
