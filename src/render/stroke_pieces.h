// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "render/screen_outline.h"
#include "text/outline_segments.h"

namespace poinsot::render {

/// A part of a stroke's middle line: at least one point, none twice in a row.
using StrokePiece = std::vector<text::Point>;

/// Cuts the middle line of a stroke into its dashes, and those into pieces of some 64 pixels that overlap a
/// little. Drawn with round ends, the pieces together are the stroke; and each pixel lies wholly within the reach
/// of one of them, so that the largest of their coverages is the stroke's.
///
/// Why pieces: added up as one outline, a line that runs over itself (a closed orbit traced ten times) would count
/// each lap and get hard, ragged edges; and a long line would need an array as large as the picture.
/// @param visible  parts that cannot be seen in it are left out
std::vector<StrokePiece> strokePieces(const draw::Stroke& stroke, const PixelBounds& visible);

}  // namespace poinsot::render
