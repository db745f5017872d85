// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <string>

#include "core/error.h"

namespace poinsot::gl {

/// A library opened at run time, so that one binary runs where either back end exists.
class SharedLibrary {
 public:
  /// @throws core::Error(kGraphics) naming the package to install.
  SharedLibrary(const char* soname, const char* package) : handle_(dlopen(soname, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_)
      throw core::Error(core::ErrorKind::kGraphics,
                        std::string(soname) + " cannot be opened; install it with: apt-get install " + package);
  }
  // Mesa and LLVM keep thread-local state and exit handlers: a library that drew is never closed.
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  template <typename Function>
  void load(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(dlsym(handle_, name));
    if (!function)
      throw core::Error(core::ErrorKind::kGraphics,
                        std::string("no function ") + name + " in the back end's library");
  }

 private:
  void* handle_;
};

}  // namespace poinsot::gl
