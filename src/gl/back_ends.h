// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "gl/offscreen_context.h"

namespace poinsot::gl {

using FunctionLoader = void (*(*)(const char*))();

// Base of both back ends' contexts. It keeps the context's place among the contexts of its thread.
class NestedContext : public OffscreenContext {
 public:
  // Records what is current on this thread, and leaves nothing current.
  NestedContext();
  // Makes the earlier context current again, unless another context has become current since.
  ~NestedContext() override;

  bool isCurrent() const final;
  // Also loads this thread's table of OpenGL functions.
  void makeCurrent() final;

 protected:
  // Must be called by the derived destructor before it destroys its context.
  void leave();

 private:
  struct Place;

  virtual bool bind() = 0;
  virtual void unbind() = 0;
  virtual bool isBound() const = 0;
  virtual FunctionLoader loader() const = 0;

  static Place& settled(Place& place);
  static thread_local std::shared_ptr<Place> latest_;

  std::shared_ptr<Place> place_;
  bool begun_ = false;
  bool restores_ = true;  // whether its end makes the earlier context current again
};

// Makes a new context current and checks that it draws (drawing_check.h).
// @throws core::Error(kGraphics) if the context is older than OpenGL 3.3 or does not draw.
void makeReady(NestedContext& context);

// Returns a function that restores the EGL (or OSMesa) context that is current on this thread; null if there is
// none. releasedEglContext() also releases that context. Neither function opens a library.
//
// Mesa's EGL and OSMesa record the current context in one place, and OSMesa reports any context found there as its
// own. So OSMesa's report counts only after EGL's context was released.
std::function<void()> releasedEglContext();
std::function<void()> callersOsMesaContext();

// Returns the context that OSMesa reports as current on this thread, which may be EGL's; null if OSMesa is not
// open.
const void* osMesasWord();

// Each of these functions is defined in the one file that knows its library. Contexts are current and ready on
// return.
// @throws core::Error(kGraphics) if the library or the context cannot be opened.
std::unique_ptr<OffscreenContext> openOsMesaContext();
void openOsMesaLibrary();
std::unique_ptr<OffscreenContext> openEglContext();

}  // namespace poinsot::gl
