// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "gl/offscreen_context.h"

// Internal to this layer.
namespace poinsot::gl {

using FunctionLoader = void (*(*)(const char*))();

// Both back ends have this in common: a context's place among those of its thread.
class NestedContext : public OffscreenContext {
 public:
  // Remembers what is current on this thread, and leaves nothing current.
  NestedContext();
  // Makes what was current before current again, unless another context has become current since.
  ~NestedContext() override;

  bool isCurrent() const final;
  // Fills this thread's table of functions, too.
  void makeCurrent() final;

 protected:
  // To be called by the derived destructor before it destroys its context.
  void leave();

 private:
  struct Place;

  virtual bool bind() = 0;  // false: the library refuses
  virtual void unbind() = 0;
  virtual bool isBound() const = 0;  // by the library's word
  virtual FunctionLoader loader() const = 0;

  static Place& settled(Place& place);
  static thread_local std::shared_ptr<Place> latest_;

  std::shared_ptr<Place> place_;
  bool begun_ = false;    // it was current
  bool restores_ = true;  // at its end
};

// Makes a new context current, and expects that it draws (drawing_check.h).
// @throws core::Error(kGraphics) when the context is older than OpenGL 3.3, or does not draw.
void makeReady(NestedContext& context);

// Returns what makes the context current again that is current on this thread by way of that library; null where
// there is none. Opens no library.
//
// Mesa's EGL and OSMesa note what is current in one place, and OSMesa takes any context that it finds there for
// one of its own: its word counts only after EGL's context was released.
std::function<void()> releasedEglContext();
std::function<void()> callersOsMesaContext();

// The context that OSMesa takes for current on this thread, of either library; null if OSMesa is not open.
const void* osMesasWord();

// Each is made in the one file that knows its library. Current on return, and ready.
std::unique_ptr<OffscreenContext> openOsMesaContext();
// @throws core::Error(kGraphics)
void openOsMesaLibrary();
std::unique_ptr<OffscreenContext> openEglContext();

}  // namespace poinsot::gl
