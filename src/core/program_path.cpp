// SPDX-License-Identifier: Apache-2.0
#include "core/program_path.h"

#include <sys/auxv.h>

#include <system_error>

namespace poinsot::core {

const char* programAsCalled() noexcept {
  const auto* name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));  // the kernel's word, before main()
  return name ? name : "";
}

std::filesystem::path programPath() {
  std::error_code failure;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
  return failure ? std::filesystem::weakly_canonical(programAsCalled(), failure) : program;
}

}  // namespace poinsot::core
