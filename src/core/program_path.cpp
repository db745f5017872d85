// SPDX-License-Identifier: Apache-2.0
#include "core/program_path.h"

#include <sys/auxv.h>

#include <system_error>

namespace poinsot::core {
namespace {

/// Returns the path by which the program was called. If relative, it refers to the working folder at the start.
const char* programAsCalled() {
  const auto* name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));  // NOLINT(performance-no-int-to-ptr)
  return name ? name : "";
}

}  // namespace

std::filesystem::path programPath() {
  std::error_code failure;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
  return failure ? std::filesystem::weakly_canonical(programAsCalled(), failure) : program;
}

std::filesystem::path ownLibraries() { return programPath().parent_path().parent_path() / "lib" / "poinsot"; }

}  // namespace poinsot::core
