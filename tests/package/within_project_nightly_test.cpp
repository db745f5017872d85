// SPDX-License-Identifier: Apache-2.0
// Builds tests/consumer/motion with poinsot inside, under flags that would change numbers. Compiling takes
// minutes.
#include <gtest/gtest.h>

#include "package/euler_steps.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

std::string motionBuiltBy(const std::string& how, const std::string& flags) {
  const ScratchFolder folder;
  const auto result = runShell(
      folder.path(),
      "set -euo pipefail\n"
      "cmake -G Ninja -S " POINSOT_SOURCE_DIR "/tests/consumer/motion -B b -DHOW=" +
          how + " -DPOINSOT=" POINSOT_SOURCE_DIR " -DCMAKE_CXX_COMPILER=" POINSOT_CXX " '-DCMAKE_CXX_FLAGS=" +
          flags + "' >log 2>&1 && cmake --build b >>log 2>&1 || { tail -n 50 log; exit 1; }\nb/motion");
  EXPECT_EQ(result.exitCode, 0) << result.out;
  return result.out;
}

TEST(WithinProjectNightly, AddSubdirectoryBuildsAWorkingLibrary) {
  expectEulersMotion(motionBuiltBy("subdirectory", "-O1"));
}

TEST(WithinProjectNightly, FetchContentBuildsAWorkingLibraryWithFastMath) {
  expectEulersMotion(motionBuiltBy("fetch", "-O3 -march=native -ffast-math"));
}

}  // namespace
}  // namespace poinsot
