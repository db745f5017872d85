// SPDX-License-Identifier: Apache-2.0
// poinsot_guard PART: does a part's work, for guard.py to count its instructions, and prints what these depend on.
#include <fmt/format.h>

#include <Eigen/Core>

#include <cstdio>
#include <exception>
#include <glm/glm.hpp>

#include "guard_parts.h"

// guard.py tells valgrind this name: between its start and its end, instructions count.
extern "C" [[gnu::noinline]] void poinsotGuardCounted(const poinsot::bench::Work& work) {
  work();
  // Else the call above would be a jump at the very end, and valgrind would not see this function's own end.
  asm volatile("" ::: "memory");
}

namespace {

using namespace poinsot;

/// What of the CPU libraries and the comparison of pictures choose their code by. Under valgrind it is that of the
/// CPU which valgrind acts: never AVX-512.
const char* cpu() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return "x86-64 with AVX2";
  return "x86-64";
#else
  return "other";
#endif
}

void printWhatCountsDependOn() {
  fmt::print("compiler: {}\nflags: {}\nEigen: {}.{}.{}\nGLM: {}.{}.{}.{}\nCPU: {}\n", POINSOT_COMPILER,
             POINSOT_FLAGS, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, GLM_VERSION_MAJOR,
             GLM_VERSION_MINOR, GLM_VERSION_PATCH, GLM_VERSION_REVISION, cpu());
}

}  // namespace

int main(int argc, char** argv) try {
  const auto part = argc == 2 ? bench::guardedParts().find(argv[1]) : bench::guardedParts().end();
  if (part == bench::guardedParts().end()) {
    fmt::print(stderr, "usage: poinsot_guard PART\n");
    return 2;
  }
  const bench::Work work = part->second();
  work();  // once before, so that memory is there and what is made once is made
  poinsotGuardCounted(work);
  printWhatCountsDependOn();
} catch (const std::exception& error) {
  fmt::print(stderr, "poinsot_guard: {}\n", error.what());
  return 3;
}
