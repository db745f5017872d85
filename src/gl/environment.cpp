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

/// Prefixes of the environment variables that Mesa reads. The poinsot program has removed them at its start. A
/// process that uses the library has not, and may need the rest of its environment.
constexpr std::string_view kMesas[] = {
    "DRAW_",                 // processing of vertices: selects the code path, one of which crashes
    "EGL_",     "__EGL_",    // EGL: library and vendor
    "GALLIUM_", "GALLIVM_",  // driver, CPU features and precision; debugging layers, some of which draw nothing
    "GLSL_",    "NIR_",      // compilation of shaders
    "LIBGL_",                // folder of the drivers
    "LP_",                   // llvmpipe: number of threads, vector width, switch that disables rasterisation
    "MESA_",                 // versions, extensions, replacement of shaders, caches
    "ST_DEBUG",              // debugging of the state tracker, such as wireframe
    "TGSI_",                 // older intermediate representation of shaders
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
  pin("GALLIUM_DRIVER", "llvmpipe");     // selects llvmpipe, never the slower softpipe
  pin("LIBGL_ALWAYS_SOFTWARE", "true");  // EGL must not select a GPU
  pin("EGL_PLATFORM", "surfaceless");
  pin("LP_NUM_THREADS", std::to_string(rasterThreads));
  // Some x86 machines have fused multiply-add instructions, which change pixels. SSE4.1 excludes them.
  if (reproducible) pin("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1");
  pinShaderCache(reproducible);
}

}  // namespace poinsot::gl
