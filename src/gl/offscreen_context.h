// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::gl {

enum class Backend { kAuto, kOsMesa, kEgl };

/// OpenGL 3.3 core context without a window. Drawing goes to framebuffer objects of the caller.
///
/// The context belongs to the thread that opened it, and replaces the context that was current there. If it is
/// still current at its end, the earlier context becomes current again; otherwise nothing changes. If the earlier
/// context was poinsot's and has ended, the one before it becomes current. Any other earlier context must still
/// exist and belong to EGL or OSMesa. The owner of a GLX context must release it and make it current again; to
/// keep it current, draw on another thread, because each thread has its own current context.
///
/// Contexts of both back ends may exist at once, on one thread or on several.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  /// Reports whether OpenGL draws with this context on the calling thread.
  virtual bool isCurrent() const = 0;
  /// Makes this context current instead of another one. @throws core::Error(kGraphics) if the back end refuses.
  virtual void makeCurrent() = 0;
  virtual const char* backendName() const = 0;  ///< "osmesa" or "egl"
  std::string renderer() const;                 ///< GL_RENDERER
  std::string version() const;                  ///< GL_VERSION
  std::string driver() const;                   ///< "Mesa 22.3.6": GL_VERSION without OpenGL's number and profile
};

/// Opens a context on this thread, loads the GL functions and checks that a triangle is drawn correctly. kAuto
/// tries OSMesa, then EGL.
/// @throws core::Error(kGraphics) if no back end works; the message says what to install.
std::unique_ptr<OffscreenContext> openContext(Backend backend);

/// Opens the library that openContext() tries first, but no context. Processes that are forked later share the
/// bound library, which saves an eighth of their start-up time. Does nothing for kEgl. openContext() reports
/// failures.
void preload(Backend backend);

/// Line of `poinsot doctor` about one OpenGL back end.
struct BackendReport {
  std::string name;
  bool works = false;
  std::string detail;  ///< renderer and version, or the reason for failure and the package to install
};
std::vector<BackendReport> probeBackends();

/// Returns why pictures of a renderer are slow and differ from those of other machines, and what to install. Empty
/// for llvmpipe.
/// @param renderer  GL_RENDERER
std::string rendererDoubt(const std::string& renderer);

/// Removes all environment variables of Mesa, which reads them once, at the first context, and sets those that
/// decide pixels and where compiled shaders are cached (gl/shader_cache.h). Call this before any GL function and
/// before other threads start.
/// @param reproducible  selects the profile that does not depend on the CPU
/// @param rasterThreads  number of threads that draw besides the calling one; they change no pixel
void pinEnvironment(bool reproducible, int rasterThreads = 0);

}  // namespace poinsot::gl
