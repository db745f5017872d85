// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/error.h"

namespace poinsot::core {

/// A library opened at run time: one binary runs where any of its back ends exists, and a process that draws no
/// film does not bind what films are made with. It is never closed: Mesa, LLVM and OpenMP keep thread-local state
/// and exit handlers.
class SharedLibrary {
 public:
  /// @param soname, package  live as long as the program: string literals.
  /// @param kind  of errors, here and below.
  /// @throws Error with the loader's reason and, where the library is missing, the package to install.
  SharedLibrary(const char* soname, const char* package, ErrorKind kind);
  /// Whether something in the process has opened the library; opens nothing.
  static bool isOpen(const char* soname);

  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// Of the library itself or of one that it needs. @throws Error where there is no such function.
  template <typename Function>
  void load(Function*& function, const char* name) const {
    find(function, name);
    if (!function) throw Error(kind_, std::string(soname_) + " has no function " + name);
  }

  /// Null where there is no such function.
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
