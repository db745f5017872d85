// SPDX-License-Identifier: Apache-2.0
#include "gl/offscreen_context.h"

#include "core/error.h"
#include "gl/back_ends.h"
#include "gl/drawing_check.h"
#include "gl/gl_includes.h"

namespace poinsot::gl {
namespace {

using core::Error;

std::string glString(GLenum name) {
  const auto* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

BackendReport probe(const char* name, std::unique_ptr<OffscreenContext> (*open)()) {
  try {
    const auto context = open();
    const std::string renderer = context->renderer(), doubt = rendererDoubt(renderer);
    return {name, true, renderer + ", OpenGL " + context->version() + (doubt.empty() ? "" : "; " + doubt)};
  } catch (const Error& error) {
    return {name, false, error.message()};
  }
}

/// Releases the context that the caller's own code made current. Returns a function that makes this context
/// current again, or null if there was none.
std::function<void()> releasedCallersContext() {
  const auto egl = releasedEglContext(), osMesa = callersOsMesaContext();
  if (!egl && !osMesa) return nullptr;
  return [=] {
    if (egl) egl();
    if (osMesa) osMesa();
  };
}

}  // namespace

/// Entry of a context in the chain of its thread. `context` is null after the context has ended. `earlier` is the
/// poinsot context that was current before. If there was none, `callers` restores the caller's context.
struct NestedContext::Place {
  NestedContext* context = nullptr;
  std::shared_ptr<Place> earlier;
  std::function<void()> callers;
};

thread_local std::shared_ptr<NestedContext::Place> NestedContext::latest_;

/// Removes contexts that have ended from the chain of earlier contexts.
NestedContext::Place& NestedContext::settled(Place& place) {
  while (place.earlier && !place.earlier->context) {
    const std::shared_ptr<Place> ended = place.earlier;
    place.earlier = ended->earlier;
    place.callers = ended->callers;
  }
  return place;
}

NestedContext::NestedContext() : place_(std::make_shared<Place>()) {
  place_->context = this;
  if (latest_ && latest_->context && latest_->context->isCurrent()) {
    place_->earlier = latest_;
    latest_->context->unbind();
  } else {
    place_->callers = releasedCallersContext();
  }
  for (Place* place = place_.get(); place; place = place->earlier.get()) settled(*place);
}

NestedContext::~NestedContext() {
  place_->context = nullptr;
  if (!restores_) return;
  const Place& before = settled(*place_);
  try {
    if (before.earlier) before.earlier->context->makeCurrent();
    if (before.callers) before.callers();
  } catch (const Error&) {  // no context is current now; the next picture reports an error
  }
}

bool NestedContext::isCurrent() const { return latest_ == place_ && isBound(); }

void NestedContext::makeCurrent() {
  if (latest_ && latest_ != place_ && latest_->context && latest_->context->isCurrent())
    latest_->context->unbind();
  if (!bind()) throw core::graphicsError(std::string(backendName()) + " cannot make its context current");
  latest_ = place_;
  begun_ = true;
  poinsot_gladLoadGL(loader());
}

void NestedContext::leave() {
  const bool current = isCurrent();
  if (current) unbind();
  restores_ = current || !begun_;
}

std::string OffscreenContext::renderer() const { return glString(GL_RENDERER); }
std::string OffscreenContext::version() const { return glString(GL_VERSION); }

std::string OffscreenContext::driver() const {
  const std::string text = version();  // example: "4.5 (Core Profile) Mesa 22.3.6"
  const std::size_t profile = text.find(") ");
  return profile == std::string::npos ? text.substr(text.find(' ') + 1) : text.substr(profile + 2);
}

void makeReady(NestedContext& context) {
  context.makeCurrent();
  if (!POINSOT_GLAD_GL_VERSION_3_3) throw core::graphicsError("the back end's OpenGL is older than 3.3");
  expectDraws();
}

std::unique_ptr<OffscreenContext> openContext(Backend backend) {
  if (backend == Backend::kOsMesa) return openOsMesaContext();
  if (backend == Backend::kEgl) return openEglContext();
  try {
    return openOsMesaContext();
  } catch (const Error& osMesaError) {
    try {
      return openEglContext();
    } catch (const Error& eglError) {
      throw core::graphicsError("no OpenGL back end works\n  osmesa: " + osMesaError.message() +
                                "\n  egl: " + eglError.message());
    }
  }
}

void preload(Backend backend) {
  if (backend == Backend::kEgl) return;
  try {
    openOsMesaLibrary();
  } catch (const Error&) {  // openContext() reports the error
  }
}

std::string rendererDoubt(const std::string& renderer) {
  if (renderer.starts_with("llvmpipe")) return "";
  return "this Mesa has no llvmpipe, and " + renderer.substr(0, renderer.find(' ')) +
         " draws more slowly and some pixels differently; install a Mesa that has it (Debian: libgl1-mesa-dri)";
}

std::vector<BackendReport> probeBackends() {
  return {probe("osmesa", openOsMesaContext), probe("egl", openEglContext)};
}

}  // namespace poinsot::gl
