// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <string>

#include "core/error.h"

namespace poinsot::gl {

/// "libX.so.1 cannot be opened: REASON", with what to install only where a file is missing: installing helps no
/// library that is there (no memory, another architecture). @param reason  of dlerror()
inline std::string whyNotOpened(const std::string& soname, const std::string& package, std::string reason) {
  if (reason.starts_with(soname + ": ")) reason.erase(0, soname.size() + 2);
  const bool missing = reason.find("No such file") != std::string::npos;
  return soname + " cannot be opened: " + reason +
         (missing ? "; install it with: apt-get install " + package : "");
}

/// A library opened at run time, so that one binary runs where either back end exists.
class SharedLibrary {
 public:
  /// @throws core::Error(kGraphics) with the loader's reason and, where the library is missing, the package to
  /// install.
  SharedLibrary(const char* soname, const char* package) : handle_(dlopen(soname, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw core::Error(core::ErrorKind::kGraphics, whyNotOpened(soname, package, dlerror()));
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
