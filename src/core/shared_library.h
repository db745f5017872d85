// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace poinsot::core {

/// Shared library that is opened at run time. One binary therefore runs with any of its back ends, and a process
/// without films does not load the film libraries. The library is never closed, because Mesa, LLVM and OpenMP keep
/// thread-local state and exit handlers.
class SharedLibrary {
 public:
  /// @param soname, package  string literals, which live as long as the program
  /// @param kind  kind of the errors that this constructor and load() throw
  /// @throws Error with the loader's reason and, if the library is missing, the package to install
  SharedLibrary(const char* soname, const char* package, ErrorKind kind);
  /// Returns whether this process has already loaded the library. Does not load it.
  static bool isOpen(const char* soname);

  /// Returns the file that the loader found.
  std::filesystem::path file() const;

  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// Looks up a function in the library and its dependencies. @throws Error if there is no such function.
  template <typename Function>
  void load(Function*& function, const char* name) const {
    find(function, name);
    if (!function) throw Error(kind_, std::string(soname_) + " has no function " + name);
  }

  /// Looks up a function, or sets a null pointer if there is no such function.
  template <typename Function>
  void find(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  const char* soname_;
  ErrorKind kind_;
  void* handle_;
};

}  // namespace poinsot::core
