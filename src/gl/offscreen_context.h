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
/// While it lives, it replaces the context that was current on the thread before. At its end the earlier context
/// is current again if it is EGL's or OSMesa's; it must still exist. A context of GLX must be released and made
/// current by its owner; to keep it current, draw on another thread, for which context is current is a matter of
/// each thread.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
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

/// What `poinsot backends` prints.
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
