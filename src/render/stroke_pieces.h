// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "render/screen_outline.h"
#include "text/outline_segments.h"

namespace poinsot::render {

/// Part of a stroke's middle line: at least one point, and none twice in a row.
using StrokePiece = std::vector<text::Point>;

/// Cuts the middle line of a stroke into its dashes, and dashes into overlapping pieces of about 64 pixels. Drawn
/// with round ends, the pieces make up the stroke. Each pixel lies wholly within the reach of one piece, so the
/// largest coverage of any piece is the coverage of the stroke.
///
/// Without pieces, a line that runs over itself (a closed orbit traced ten times) would count each lap and get
/// hard, ragged edges, and a long line would need an array as large as the picture.
/// @param visible  rectangle outside which parts are left out
std::vector<StrokePiece> strokePieces(const draw::Stroke& stroke, const PixelBounds& visible);

}  // namespace poinsot::render
