// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::gl {

/// Draws a triangle over a ground of another colour, and reads both back. A driver may report success for every
/// call and draw nothing, or outlines only, if its debugging settings say so; no later check would notice that.
/// @pre a context is current and its functions are loaded.
/// @throws core::Error(kGraphics) when a pixel is not what was drawn.
void expectDraws();

}  // namespace poinsot::gl
