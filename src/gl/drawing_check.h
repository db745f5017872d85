// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::gl {

/// Draws a triangle over a ground of another colour, and reads both back. With some debugging settings, a driver
/// reports success for every call and draws nothing, or only outlines; no later check would notice that.
/// @pre a context is current and its functions are loaded.
/// @throws core::Error(kGraphics) if a pixel has a wrong colour.
void expectDraws();

}  // namespace poinsot::gl
