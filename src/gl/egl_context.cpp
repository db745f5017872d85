// SPDX-License-Identifier: Apache-2.0
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "core/shared_library.h"
#include "gl/back_ends.h"

namespace poinsot::gl {
namespace {

using core::Error;
using core::ErrorKind;

struct EglFunctions {
  core::SharedLibrary library{"libEGL.so.1", "libegl1 libgl1-mesa-dri", ErrorKind::kGraphics};
  decltype(eglGetProcAddress)* getProcAddress;
  decltype(eglInitialize)* initialize;
  decltype(eglTerminate)* terminate;
  decltype(eglBindAPI)* bindApi;
  decltype(eglCreateContext)* createContext;
  decltype(eglDestroyContext)* destroyContext;
  decltype(eglMakeCurrent)* makeCurrent;

  EglFunctions() {
    library.load(getProcAddress, "eglGetProcAddress");
    library.load(initialize, "eglInitialize");
    library.load(terminate, "eglTerminate");
    library.load(bindApi, "eglBindAPI");
    library.load(createContext, "eglCreateContext");
    library.load(destroyContext, "eglDestroyContext");
    library.load(makeCurrent, "eglMakeCurrent");
  }
};

const EglFunctions& egl() {
  static const EglFunctions functions;
  return functions;
}

EGLDisplay surfacelessDisplay() {
  const auto getPlatformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl().getProcAddress("eglGetPlatformDisplayEXT"));
  if (!getPlatformDisplay) throw Error(ErrorKind::kGraphics, "EGL is too old: it has no platform displays");
  EGLDisplay display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !egl().initialize(display, nullptr, nullptr))
    throw Error(ErrorKind::kGraphics,
                "EGL has no surfaceless Mesa display; install it with: apt-get install libgl1-mesa-dri");
  return display;
}

class EglContext final : public OffscreenContext {
 public:
  EglContext() : display_(surfacelessDisplay()) {
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
    egl().bindApi(EGL_OPENGL_API);
    context_ = egl().createContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (context_ == EGL_NO_CONTEXT || !egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      egl().terminate(display_);
      throw Error(ErrorKind::kGraphics, "EGL gives no surfaceless OpenGL 3.3 core context");
    }
  }
  ~EglContext() override {
    egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl().destroyContext(display_, context_);
    egl().terminate(display_);
  }
  const char* backendName() const override { return "egl"; }

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<OffscreenContext> openEglContext() {
  auto context = std::make_unique<EglContext>();
  makeReady(reinterpret_cast<FunctionLoader>(egl().getProcAddress));
  return context;
}

}  // namespace poinsot::gl
