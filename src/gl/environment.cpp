// SPDX-License-Identifier: Apache-2.0
#include "core/environment.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "gl/offscreen_context.h"
#include "gl/shader_cache.h"

namespace poinsot::gl {
namespace {

/// Prefixes of the environment variables that Mesa reads. The program has removed all of them already; a process
/// that uses the library may need the rest of its environment.
constexpr std::string_view kMesas[] = {
    "DRAW_",                 // vertices: code path (one of them crashes)
    "EGL_",     "__EGL_",    // EGL library and vendor
    "GALLIUM_", "GALLIVM_",  // driver, CPU features, precision; layers that trace or draw nothing
    "GLSL_",    "NIR_",      // the shader compiler
    "LIBGL_",                // the driver's folder
    "LP_",                   // llvmpipe: threads, vector width, no rasterisation
    "MESA_",                 // versions, extensions, replaced shaders, caches
    "ST_DEBUG",              // the state tracker: wireframe
    "TGSI_",                 // shaders of the older kind
};

bool isMesas(std::string_view name) {
  return std::ranges::any_of(kMesas, [&](std::string_view start) { return name.starts_with(start); });
}

void pin(const char* name, const std::string& value) { setenv(name, value.c_str(), 1); }

void pinShaderCache(bool reproducible) {
  const std::filesystem::path folder = shaderCacheFolder(reproducible);
  pin("MESA_SHADER_CACHE_DISABLE", folder.empty() ? "true" : "false");
  pin("MESA_SHADER_CACHE_DIR", folder);
  pin("MESA_SHADER_CACHE_MAX_SIZE", "64M");
}

}  // namespace

void pinEnvironment(bool reproducible, int rasterThreads) {
  core::clearEnvironment([](std::string_view name) { return !isMesas(name); });
  pin("GALLIUM_DRIVER", "llvmpipe");     // never softpipe by accident
  pin("LIBGL_ALWAYS_SOFTWARE", "true");  // EGL: never a GPU by accident
  pin("EGL_PLATFORM", "surfaceless");
  pin("LP_NUM_THREADS", std::to_string(rasterThreads));
  // Pixels differ between x86 machines because some use FMA. SSE4.1 has none.
  if (reproducible) pin("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1");
  pinShaderCache(reproducible);
}

}  // namespace poinsot::gl
