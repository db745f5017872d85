// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "gl/offscreen_context.h"

namespace poinsot::gl {

using FunctionLoader = void (*(*)(const char*))();

// Internal. Fills glad's table for the current context, and expects that it draws (drawing_check.h).
// @throws core::Error(kGraphics) when the context is older than OpenGL 3.3, or does not draw.
void makeReady(FunctionLoader loader);

// Each is made in the one file that knows its library. Current on return, and ready.
std::unique_ptr<OffscreenContext> openOsMesaContext();
// @throws core::Error(kGraphics)
void openOsMesaLibrary();
std::unique_ptr<OffscreenContext> openEglContext();

}  // namespace poinsot::gl
