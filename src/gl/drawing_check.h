// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::gl {

/// Checks that OpenGL draws: draws a triangle on a background of another colour and reads a pixel of each. With
/// some debugging settings, a driver reports success for every call but draws nothing, or only outlines.
/// @pre a context is current and its functions are loaded.
/// @throws core::Error(kGraphics) if a pixel has a wrong colour.
void expectDraws();

}  // namespace poinsot::gl
