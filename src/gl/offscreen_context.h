// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::gl {

enum class Backend { kAuto, kOsMesa, kEgl };

/// OpenGL 3.3 core context without a window. The caller draws to framebuffer objects.
///
/// A context belongs to the thread that opened it and replaces the context that was current there. If the context
/// is still current when it is destroyed, the earlier context becomes current again. If the earlier context was
/// poinsot's and has been destroyed, the one before it becomes current.
///
/// An earlier context of another library must still exist and belong to EGL or OSMesa. The owner of a GLX context
/// must release it beforehand and make it current again afterwards. To avoid that, draw on another thread, because
/// each thread has its own current context.
///
/// Contexts of both back ends may exist at once, on one thread or on several.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  /// Reports whether OpenGL calls on this thread go to this context.
  virtual bool isCurrent() const = 0;
  /// Makes this context current on the calling thread.
  /// @throws core::Error(kGraphics) if the back end refuses.
  virtual void makeCurrent() = 0;
  virtual const char* backendName() const = 0;  ///< "osmesa" or "egl"
  std::string renderer() const;                 ///< GL_RENDERER
  std::string version() const;                  ///< GL_VERSION
  std::string driver() const;                   ///< version of Mesa, such as "Mesa 22.3.6", taken from GL_VERSION
};

/// Opens a context on this thread, loads the OpenGL functions and checks that a triangle is drawn correctly. kAuto
/// tries OSMesa, then EGL.
/// @throws core::Error(kGraphics) if no back end works; the message says what to install.
std::unique_ptr<OffscreenContext> openContext(Backend backend);

/// Opens the library that openContext() would try first, but no context. Processes that are forked afterwards use
/// the loaded library, which saves an eighth of their start-up time. Does nothing for kEgl. Errors are ignored
/// here and reported by openContext().
void preload(Backend backend);

/// Result of `poinsot doctor` for one OpenGL back end.
struct BackendReport {
  std::string name;
  bool works = false;
  /// If the back end works, its renderer and version; otherwise the reason and the package to install
  std::string detail;
};
std::vector<BackendReport> probeBackends();

/// Returns a warning if a renderer is not llvmpipe: pictures are slow and differ from those of other machines. The
/// warning says what to install. Returns an empty string for llvmpipe.
/// @param renderer  the string GL_RENDERER of the context
std::string rendererDoubt(const std::string& renderer);

/// Prepares the environment variables of Mesa: removes all of them, then sets those that determine pixels and the
/// folder of compiled shaders (gl/shader_cache.h). Call this function before any OpenGL function, because Mesa
/// reads its variables only once, and before other threads start.
/// @param reproducible  selects the profile whose pixels do not depend on the CPU
/// @param rasterThreads  number of threads that draw in addition to the calling thread; pixels do not depend on it
void pinEnvironment(bool reproducible, int rasterThreads = 0);

}  // namespace poinsot::gl
