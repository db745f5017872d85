// SPDX-License-Identifier: Apache-2.0
#include "gl/offscreen_context.h"

#include "core/error.h"
#include "gl/back_ends.h"
#include "gl/drawing_check.h"
#include "gl/gl_includes.h"

namespace poinsot::gl {
namespace {

using core::Error;
using core::ErrorKind;

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

thread_local int ours = 0;  // contexts of this thread

}  // namespace

CallersContext::CallersContext() {
  if (ours++ > 0) return;  // one of ours may end before another
  egl_ = callersEglContext();
  osMesa_ = callersOsMesaContext();
}

CallersContext::~CallersContext() {
  --ours;
  if (egl_) egl_();
  if (osMesa_) osMesa_();
}

std::string OffscreenContext::renderer() const { return glString(GL_RENDERER); }
std::string OffscreenContext::version() const { return glString(GL_VERSION); }

std::string OffscreenContext::driver() const {
  const std::string text = version();  // "4.5 (Core Profile) Mesa 22.3.6"
  const std::size_t profile = text.find(") ");
  return profile == std::string::npos ? text.substr(text.find(' ') + 1) : text.substr(profile + 2);
}

void makeReady(FunctionLoader loader) {
  const int version = poinsot_gladLoadGL(loader);
  if (version < POINSOT_GLAD_MAKE_VERSION(3, 3))
    throw Error(ErrorKind::kGraphics, "the back end's OpenGL is older than 3.3");
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
      throw Error(ErrorKind::kGraphics, "no OpenGL back end works\n  osmesa: " + osMesaError.message() +
                                            "\n  egl: " + eglError.message());
    }
  }
}

void preload(Backend backend) {
  if (backend == Backend::kEgl) return;
  try {
    openOsMesaLibrary();
  } catch (const Error&) {  // told where it is wanted
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
