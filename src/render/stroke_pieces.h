// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "render/screen_outline.h"
#include "text/outline_segments.h"

namespace poinsot::render {

/// Part of a stroke's centre line. It has at least one point, and no two consecutive points are equal.
using StrokePiece = std::vector<text::Point>;

/// Divides the centre line of a stroke into its dashes, and each dash into overlapping pieces of about 64 pixels.
/// Pieces overlap by more than a pixel, so every pixel of the stroke has a piece that does not end in it. The
/// coverage of the stroke in a pixel is therefore the largest coverage of any piece.
///
/// Without pieces, a line that passes over itself, such as a closed orbit traced ten times, would add up the
/// coverage of its laps and get hard, ragged edges. A long line would also need an array as large as the picture.
/// @param visible  parts outside this rectangle are left out
std::vector<StrokePiece> strokePieces(const draw::Stroke& stroke, const PixelBounds& visible);

}  // namespace poinsot::render
