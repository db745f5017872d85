// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "gl/offscreen_context.h"
#include "gl/shader_cache.h"

namespace poinsot::gl {
namespace {

void pinShaderCache(bool reproducible) {
  for (const char* name : {"MESA_DISK_CACHE_SINGLE_FILE", "MESA_DISK_CACHE_DATABASE", "MESA_GLSL_CACHE_DIR",
                           "MESA_GLSL_CACHE_DISABLE", "MESA_DISK_CACHE_READ_ONLY_FOZ_DBS"})
    unsetenv(name);
  const std::filesystem::path folder = shaderCacheFolder(reproducible);
  setenv("MESA_SHADER_CACHE_DISABLE", folder.empty() ? "true" : "false", 1);
  setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "64M", 1);
}

}  // namespace

void pinEnvironment(bool reproducible) {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);     // never softpipe by accident
  setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);  // EGL: never a GPU by accident
  setenv("EGL_PLATFORM", "surfaceless", 1);
  pinShaderCache(reproducible);
  // A worker is one process on one core; 0 lets llvmpipe rasterise in the calling thread.
  setenv("LP_NUM_THREADS", "0", 0);
  // These change pixels or the API; whoever set them did not mean this program.
  for (const char* name : {"GALLIVM_PERF", "LP_PERF", "LP_NATIVE_VECTOR_WIDTH", "MESA_EXTENSION_OVERRIDE",
                           "MESA_GL_VERSION_OVERRIDE", "MESA_GLSL_VERSION_OVERRIDE", "LP_DEBUG", "LP_RAST"})
    unsetenv(name);
  // FMA or no FMA is what moves pixels between x86 machines; SSE4.1 has none.
  if (reproducible)
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
  else
    unsetenv("GALLIUM_OVERRIDE_CPU_CAPS");
}

}  // namespace poinsot::gl
