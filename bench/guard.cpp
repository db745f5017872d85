// SPDX-License-Identifier: Apache-2.0
// poinsot_guard PART: runs a part, whose instructions guard.py counts, and prints what the counts depend on.
#include <fmt/format.h>

#include <Eigen/Core>

#include <cstdio>
#include <exception>
#include <glm/glm.hpp>

#include "guard_parts.h"

// guard.py passes this name to valgrind, which counts the instructions between the function's start and its end.
extern "C" [[gnu::noinline]] void poinsotGuardCounted(const poinsot::bench::Work& work) {
  work();
  // Keeps the call above from becoming a jump, after which valgrind would not see the end of this function.
  asm volatile("" ::: "memory");
}

namespace {

using namespace poinsot;

/// Returns the CPU features by which the CPU libraries and the comparison of pictures choose their code. Under
/// valgrind, these are features of the emulated CPU: never AVX-512.
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
  work();  // a first run, which allocates memory and makes what is made once
  poinsotGuardCounted(work);
  printWhatCountsDependOn();
} catch (const std::exception& error) {
  fmt::print(stderr, "poinsot_guard: {}\n", error.what());
  return 3;
}
