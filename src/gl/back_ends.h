// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "gl/offscreen_context.h"

namespace poinsot::gl {

using FunctionLoader = void (*(*)(const char*))();

// Internal. Fills glad's table for the current context, and expects that it draws (drawing_check.h).
// @throws core::Error(kGraphics) when the context is older than OpenGL 3.3, or does not draw.
void makeReady(FunctionLoader loader);

// Returns what makes the context current again that is current on this thread by way of that library; null where
// there is none. Opens no library.
std::function<void()> callersOsMesaContext();
std::function<void()> callersEglContext();

// Remembers the caller's context when the thread has none of ours yet. At the end of its own life, which is after
// that of a context of ours, it makes the caller's current again: the first member of such a context.
class CallersContext {
 public:
  CallersContext();
  ~CallersContext();
  CallersContext(const CallersContext&) = delete;
  CallersContext& operator=(const CallersContext&) = delete;

 private:
  std::function<void()> egl_, osMesa_;  // null: nothing to do
};

// Each is made in the one file that knows its library. Current on return, and ready.
std::unique_ptr<OffscreenContext> openOsMesaContext();
// @throws core::Error(kGraphics)
void openOsMesaLibrary();
std::unique_ptr<OffscreenContext> openEglContext();

}  // namespace poinsot::gl
