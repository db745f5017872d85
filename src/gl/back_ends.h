// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "gl/offscreen_context.h"

namespace poinsot::gl {

using FunctionLoader = void (*(*)(const char*))();

// Base class of both back ends' contexts. It keeps track of which context was current before.
class NestedContext : public OffscreenContext {
 public:
  // Records which context is current on this thread, and makes no context current.
  NestedContext();
  // Makes the context that was current before this one current again, unless a third context has become current.
  ~NestedContext() override;

  bool isCurrent() const final;
  // Makes the context current and loads this thread's table of OpenGL functions.
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
  bool restores_ = true;  // whether the destructor makes the previous context current again
};

// Makes a new context current and checks that it draws (drawing_check.h).
// @throws core::Error(kGraphics) if the context is older than OpenGL 3.3 or does not draw.
void makeReady(NestedContext& context);

// Each function returns a function that makes the caller's current EGL or OSMesa context current again, or null if
// no such context is current. releasedEglContext() also releases the context. Neither function opens a library.
//
// Mesa's EGL and OSMesa record the current context in the same variable, so OSMesa reports EGL's context as its
// own. The report of OSMesa is therefore valid only after EGL's context was released.
std::function<void()> releasedEglContext();
std::function<void()> callersOsMesaContext();

// Returns the context that OSMesa reports as current on this thread; it may be EGL's. Null if OSMesa is not open.
const void* osMesasWord();

// Opens a context, makes it current and checks it. Each back end has its own source file.
// @throws core::Error(kGraphics) if the library or the context cannot be opened.
std::unique_ptr<OffscreenContext> openOsMesaContext();
void openOsMesaLibrary();
std::unique_ptr<OffscreenContext> openEglContext();

}  // namespace poinsot::gl
