// SPDX-License-Identifier: Apache-2.0
// Checks that a program's own context, made by the libraries' functions, is current before and after a context of
// poinsot's.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <thread>
#include <utility>

#include "core/shared_library.h"
#include "gl/offscreen_context.h"
#include "gl/osmesa.h"
#include "support/back_ends.h"

namespace poinsot::gl {
namespace {

/// Context with one buffer object, which distinguishes it from other contexts.
class ProgramsContext {
 public:
  virtual ~ProgramsContext() = default;

  void makeBuffer() {
    std::array<GLuint, 7> names{};  // more than a context of poinsot's has
    find<PFNGLGENBUFFERSPROC>("glGenBuffers")(7, names.data());
    buffer_ = names.back();
    find<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_ARRAY_BUFFER, buffer_);
  }
  bool isCurrent() { return find<PFNGLISBUFFERPROC>("glIsBuffer")(buffer_) == GL_TRUE; }

 protected:
  using Function = void (*)();
  virtual Function address(const char* name) = 0;
  template <class F>
  F find(const char* name) {
    return reinterpret_cast<F>(address(name));
  }

 private:
  GLuint buffer_ = 0;
};

class EglProgram final : public ProgramsContext {
 public:
  EglProgram() {
    load<decltype(eglGetProcAddress)>("eglGetProcAddress");
    const auto getDisplay = find<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    display_ = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    load<decltype(eglInitialize)>("eglInitialize")(display_, nullptr, nullptr);
    load<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API);
    context_ = make();
    load<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    makeBuffer();
  }
  ~EglProgram() override {
    load<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    load<decltype(eglTerminate)>("eglTerminate")(display_);
  }

  EGLContext make() {
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    return load<decltype(eglCreateContext)>("eglCreateContext")(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                                                kAttributes);
  }

 private:
  template <class F>
  F* load(const char* name) {
    F* function = nullptr;
    library_.load(function, name);
    return function;
  }
  Function address(const char* name) override {
    return load<decltype(eglGetProcAddress)>("eglGetProcAddress")(name);
  }

  core::SharedLibrary library_{"libEGL.so.1", "libegl1", core::ErrorKind::kGraphics};
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

class OsMesaProgram final : public ProgramsContext {
 public:
  OsMesaProgram() {
    constexpr int kAttributes[] = {
        OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
    context_ = load<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs")(kAttributes, nullptr);
    load<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent")(context_, pixels_.data(), GL_UNSIGNED_SHORT, 2, 1);
    makeBuffer();
  }
  ~OsMesaProgram() override { load<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")(context_); }

  /// Clears with red, and returns the buffer that the program gave the context.
  std::array<GLushort, 8> cleared() {
    find<PFNGLCLEARCOLORPROC>("glClearColor")(1, 0, 0, 1);
    find<PFNGLCLEARPROC>("glClear")(GL_COLOR_BUFFER_BIT);
    find<PFNGLFINISHPROC>("glFinish")();
    return std::exchange(pixels_, {});
  }

 private:
  template <class F>
  F* load(const char* name) {
    F* function = nullptr;
    library_.load(function, name);
    return function;
  }
  Function address(const char* name) override {
    return load<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress")(name);
  }

  core::SharedLibrary library_{"libOSMesa.so.8", "libosmesa6", core::ErrorKind::kGraphics};
  OSMesaContext context_ = nullptr;
  std::array<GLushort, 8> pixels_{};
};

class CallersContextTest : public testing::TestWithParam<Backend> {
 protected:
  void SetUp() override { pinEnvironment(true); }

  /// Returns whether a context of that back end takes the place of a current one of OSMesa's. EGL's does if both
  /// keep the current context in libglapi. Mesa 25 has no such library, so that each back end has a current
  /// context of its own.
  static bool replacesOsMesa(Backend backend) {
    return backend == Backend::kOsMesa || dlopen("libglapi.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr;
  }
};

TEST_P(CallersContextTest, EglContextOfTheCallerIsRestored) {
  EglProgram program;
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(program.isCurrent());
    const auto context = openContext(GetParam());
    EXPECT_FALSE(program.isCurrent());
    const auto inner = openContext(Backend::kAuto);
  }
  EXPECT_TRUE(program.isCurrent());
  EXPECT_NE(program.make(), EGL_NO_CONTEXT) << "its display was closed";
}

TEST_P(CallersContextTest, OsMesaContextOfTheCallerIsRestoredWithItsBuffer) {
  POINSOT_NEEDS_OSMESA();
  OsMesaProgram program;
  constexpr std::array<GLushort, 8> kRed{65535, 0, 0, 65535, 65535, 0, 0, 65535};
  ASSERT_EQ(program.cleared(), kRed);
  {
    const auto context = openContext(GetParam());
    EXPECT_NE(program.isCurrent(), replacesOsMesa(GetParam()));
  }
  EXPECT_TRUE(program.isCurrent());
  EXPECT_EQ(program.cleared(), kRed);
}

TEST_P(CallersContextTest, OsMesaContextIsRestoredAboveAnEglContext) {
  POINSOT_NEEDS_OSMESA();
  EglProgram below;
  OsMesaProgram program;
  {
    const auto context = openContext(GetParam());
    EXPECT_NE(program.isCurrent(), replacesOsMesa(GetParam()));
  }
  EXPECT_TRUE(program.isCurrent());
}

TEST_P(CallersContextTest, OsMesaContextIsRestoredAboveAPoinsotContext) {
  POINSOT_NEEDS_OSMESA();
  const auto outer = openContext(GetParam());
  OsMesaProgram program;
  EXPECT_NE(outer->isCurrent(), replacesOsMesa(GetParam()));
  openContext(GetParam());
  EXPECT_TRUE(program.isCurrent());
  outer->makeCurrent();
  EXPECT_TRUE(outer->isCurrent());
}

// OSMesa mistakes EGL's context for one of its own, and prints a complaint if it has to make that context current.
TEST_P(CallersContextTest, EglContextIsNotPassedToOsMesa) {
  POINSOT_NEEDS_OSMESA();
  preload(Backend::kOsMesa);
  testing::internal::CaptureStderr();
  {
    EglProgram program;
    openContext(GetParam());
    EXPECT_TRUE(program.isCurrent());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(CallersContextTest, ContextOfAnotherThreadIsUnchanged) {
  EglProgram program;
  std::thread([] { openContext(GetParam()); }).join();
  EXPECT_TRUE(program.isCurrent());
}

INSTANTIATE_TEST_SUITE_P(BackEnds, CallersContextTest, testing::ValuesIn(backEnds()),
                         [](const auto& backend) { return testName(backend.param); });

// All contexts of a process share one display without surfaces. The end of one context must not close the display
// for another.
TEST(EglContexts, CanBeDestroyedInAnyOrder) {
  pinEnvironment(true);
  auto first = openContext(Backend::kEgl);
  std::thread([&] {
    const auto second = openContext(Backend::kEgl);
    std::thread([] { openContext(Backend::kEgl); }).join();
    EXPECT_NE(second->renderer(), "");
    openContext(Backend::kEgl);
  }).join();
  EXPECT_NE(first->renderer(), "");
}

}  // namespace
}  // namespace poinsot::gl
