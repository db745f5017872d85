// SPDX-License-Identifier: Apache-2.0
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <system_error>

#include "core/shared_library.h"
#include "gl/back_ends.h"

namespace poinsot::gl {
namespace {

using core::Error;
using core::ErrorKind;

constexpr const char* kEglLibrary = "libEGL.so.1";

struct EglFunctions {
  core::SharedLibrary library{kEglLibrary, "libegl1 libgl1-mesa-dri", ErrorKind::kGraphics};
  decltype(eglGetProcAddress)* getProcAddress;
  decltype(eglInitialize)* initialize;
  decltype(eglTerminate)* terminate;
  decltype(eglBindAPI)* bindApi;
  decltype(eglCreateContext)* createContext;
  decltype(eglDestroyContext)* destroyContext;
  decltype(eglMakeCurrent)* makeCurrent;
  decltype(eglQueryAPI)* queryApi;
  decltype(eglQueryString)* queryString;
  decltype(eglGetCurrentContext)* getCurrentContext;
  decltype(eglGetCurrentDisplay)* getCurrentDisplay;
  decltype(eglGetCurrentSurface)* getCurrentSurface;

  EglFunctions() {
    library.load(getProcAddress, "eglGetProcAddress");
    library.load(initialize, "eglInitialize");
    library.load(terminate, "eglTerminate");
    library.load(bindApi, "eglBindAPI");
    library.load(createContext, "eglCreateContext");
    library.load(destroyContext, "eglDestroyContext");
    library.load(makeCurrent, "eglMakeCurrent");
    library.load(queryApi, "eglQueryAPI");
    library.load(queryString, "eglQueryString");
    library.load(getCurrentContext, "eglGetCurrentContext");
    library.load(getCurrentDisplay, "eglGetCurrentDisplay");
    library.load(getCurrentSurface, "eglGetCurrentSurface");
  }
};

const EglFunctions& egl() {
  static const EglFunctions functions;
  return functions;
}

/// During its lifetime, libEGL loads the drivers that a list beside it names. A portable package has such a list
/// and its own Mesa. Without a list, or if the user names another one, nothing changes.
class OwnDriver {
 public:
  OwnDriver() {
    const auto list = egl().library.file().parent_path() / "poinsot_egl.json";
    std::error_code ignored;
    chosen_ = !std::getenv(kVariable) && std::filesystem::exists(list, ignored) &&
              setenv(kVariable, list.c_str(), 0) == 0;
  }
  ~OwnDriver() {
    if (chosen_) unsetenv(kVariable);  // programs that this process starts have other drivers
  }
  OwnDriver(const OwnDriver&) = delete;
  OwnDriver& operator=(const OwnDriver&) = delete;

 private:
  static constexpr const char* kVariable = "__EGL_VENDOR_LIBRARY_FILENAMES";
  bool chosen_ = false;
};

/// EGL display without a window system. A process has only one such display, which the caller may use too. It is
/// terminated with our last context, unless it was already initialised before our first context.
class SurfacelessDisplay {
 public:
  SurfacelessDisplay() {
    const std::lock_guard lock(mutex_);
    if (users_ == 0) wasThere_ = egl().queryString(display_, EGL_VERSION) != nullptr;
    if (!egl().initialize(display_, nullptr, nullptr)) throw missing();
    ++users_;
  }
  ~SurfacelessDisplay() {
    const std::lock_guard lock(mutex_);
    if (--users_ == 0 && !wasThere_) egl().terminate(display_);
  }
  SurfacelessDisplay(const SurfacelessDisplay&) = delete;
  SurfacelessDisplay& operator=(const SurfacelessDisplay&) = delete;

  operator EGLDisplay() const { return display_; }

 private:
  static Error missing();
  static EGLDisplay find();

  static inline std::mutex mutex_;
  static inline int users_ = 0;
  static inline bool wasThere_ = false;
  const EGLDisplay display_ = find();
};

Error SurfacelessDisplay::missing() {
  return Error(ErrorKind::kGraphics,
               "EGL has no surfaceless Mesa display; install it with: apt-get install libgl1-mesa-dri");
}

EGLDisplay SurfacelessDisplay::find() {
  const OwnDriver driver;  // libEGL loads its drivers when it is asked for the first function
  const auto getPlatformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl().getProcAddress("eglGetPlatformDisplayEXT"));
  if (!getPlatformDisplay) throw core::graphicsError("EGL is too old: it has no platform displays");
  const EGLDisplay display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) throw missing();
  return display;
}

class EglContext final : public NestedContext {
 public:
  EglContext() {
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
    egl().bindApi(EGL_OPENGL_API);
    context_ = egl().createContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (context_ == EGL_NO_CONTEXT) throw core::graphicsError("EGL gives no surfaceless OpenGL 3.3 core context");
  }
  ~EglContext() override {
    leave();
    egl().destroyContext(display_, context_);
  }
  const char* backendName() const override { return "egl"; }

 private:
  bool bind() override {
    // EGL may still consider this context current after OSMesa has replaced it. EGL would then do nothing.
    unbind();
    egl().bindApi(EGL_OPENGL_API);
    const bool bound = egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    osMesasWord_ = osMesasWord();
    return bound;
  }
  void unbind() override { egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  bool isBound() const override {
    // An OSMesa context may have replaced this one. The check compares what OSMesa reports now with what it
    // reported in bind(). If OSMesa was not open in bind(), no comparison is possible.
    return egl().getCurrentContext() == context_ && (!osMesasWord_ || osMesasWord_ == osMesasWord());
  }
  FunctionLoader loader() const override { return reinterpret_cast<FunctionLoader>(egl().getProcAddress); }

  SurfacelessDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  const void* osMesasWord_ = nullptr;
};

}  // namespace

std::function<void()> releasedEglContext() {
  const EGLContext context = core::SharedLibrary::isOpen(kEglLibrary) ? egl().getCurrentContext() : EGL_NO_CONTEXT;
  if (context == EGL_NO_CONTEXT) return nullptr;
  auto restore = [api = egl().queryApi(), display = egl().getCurrentDisplay(),
                  draw = egl().getCurrentSurface(EGL_DRAW), read = egl().getCurrentSurface(EGL_READ), context] {
    egl().bindApi(api);
    egl().makeCurrent(display, draw, read, context);
  };
  egl().makeCurrent(egl().getCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return restore;
}

std::unique_ptr<OffscreenContext> openEglContext() {
  auto context = std::make_unique<EglContext>();
  makeReady(*context);
  return context;
}

}  // namespace poinsot::gl
