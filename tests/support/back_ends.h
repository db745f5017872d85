// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <string>
#include <vector>

#include "gl/offscreen_context.h"

// Skips a test that needs both back ends if the system has no OSMesa, which Mesa dropped in 25.1.
#define POINSOT_NEEDS_OSMESA() \
  if (!hasOsMesa()) GTEST_SKIP() << "this system has no OSMesa"

namespace poinsot {

/// Returns whether the system's loader finds OSMesa; independent of the code under test.
inline bool hasOsMesa() {
  static void* const library = dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
  return library != nullptr;
}

/// Returns the command-line names of the back ends that this system has.
inline std::vector<std::string> backEndNames() {
  if (hasOsMesa()) return {"osmesa", "egl"};
  return {"egl"};
}

inline std::vector<gl::Backend> backEnds() {
  if (hasOsMesa()) return {gl::Backend::kOsMesa, gl::Backend::kEgl};
  return {gl::Backend::kEgl};
}

/// Returns "OsMesa" or "Egl", for the name of a parameterised test.
inline std::string testName(gl::Backend backend) { return backend == gl::Backend::kEgl ? "Egl" : "OsMesa"; }

}  // namespace poinsot
