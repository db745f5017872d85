// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <string>
#include <vector>

#include "gl/offscreen_context.h"

// Mesa has no OSMesa since 25.1. A test of both back ends begins with this.
#define POINSOT_NEEDS_OSMESA() \
  if (!hasOsMesa()) GTEST_SKIP() << "this system has no OSMesa"

namespace poinsot {

/// Asks the system itself, not the code under test.
inline bool hasOsMesa() {
  static void* const library = dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
  return library != nullptr;
}

/// The back ends that the system has, by the names of the command line.
inline std::vector<std::string> backEndNames() {
  if (hasOsMesa()) return {"osmesa", "egl"};
  return {"egl"};
}

/// The back ends that the system has.
inline std::vector<gl::Backend> backEnds() {
  if (hasOsMesa()) return {gl::Backend::kOsMesa, gl::Backend::kEgl};
  return {gl::Backend::kEgl};
}

/// "OsMesa" or "Egl", for the name of a test.
inline std::string testName(gl::Backend backend) { return backend == gl::Backend::kEgl ? "Egl" : "OsMesa"; }

}  // namespace poinsot
