// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/abi.h"

namespace poinsot::gl {

enum class Backend { kAuto, kOsMesa, kEgl };

/// A current OpenGL 3.3 core context without a window. Drawing goes to framebuffer objects of the caller's.
///
/// It belongs to the thread that opened it, and replaces the context that was current there. If it is still
/// current at its end, the earlier context becomes current again; otherwise nothing changes. An earlier poinsot
/// context may have ended before: then it is the one before that. Another earlier context must still exist, and be
/// EGL's or OSMesa's. A context of GLX must be released and made current by its owner; to keep it current, draw on
/// another thread, as each thread has a current context of its own.
///
/// Contexts of both back ends may live at once, on one thread or on several.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  /// Whether OpenGL draws with this context on the calling thread.
  virtual bool isCurrent() const = 0;
  /// Makes it current in place of another one. @throws core::Error(kGraphics) if the back end refuses.
  virtual void makeCurrent() = 0;
  virtual const char* backendName() const = 0;  ///< "osmesa" or "egl"
  std::string renderer() const;                 ///< GL_RENDERER
  std::string version() const;                  ///< GL_VERSION
  std::string driver() const;                   ///< "Mesa 22.3.6": GL_VERSION without OpenGL's number and profile
};

/// Opens a context on this thread, loads the GL functions and expects that a triangle comes out as drawn. kAuto
/// takes OSMesa, else EGL.
/// @throws core::Error(kGraphics) saying what to install, when none works.
std::unique_ptr<OffscreenContext> openContext(Backend backend);

/// Opens what openContext() would look for first, but no context: processes that are forked then share the library
/// as it is bound, an eighth of their start. Failing is left to openContext().
void preload(Backend backend);

/// A line of `poinsot doctor` on OpenGL.
struct BackendReport {
  std::string name;
  bool works = false;
  std::string detail;  ///< renderer and version, or why not and which package to install
};
std::vector<BackendReport> probeBackends();

/// Returns why pictures of this renderer are slow and not quite those of other machines, and what to install.
/// Empty for llvmpipe.
/// @param renderer  GL_RENDERER
std::string rendererDoubt(const std::string& renderer);

/// Clears every environment variable of Mesa's (it reads them once, at the first context), and sets those that
/// decide pixels and where compiled shaders are kept (gl/shader_cache.h). Call before any GL, and before other
/// threads.
/// @param reproducible  asks for the profile that does not depend on the CPU
/// @param rasterThreads  threads that draw beside the calling one; they change no pixel
void pinEnvironment(bool reproducible, int rasterThreads = 0);

}  // namespace poinsot::gl
