// SPDX-License-Identifier: Apache-2.0
// Draws and compares the pictures of golden.toml with the command `golden`. build/golden/BACKEND.html shows
// pictures that are not identical.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/back_ends.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

fs::path made(const std::string& backend) { return fs::path(POINSOT_BINARY_DIR) / "golden" / backend; }

ShellResult runSuite(const std::string& backend) {
  fs::create_directories(made(backend));
  return runShell(POINSOT_SOURCE_DIR, POINSOT_PROGRAM " golden tests/golden/golden.toml --backend " + backend +
                                          " -o " + made(backend).string() + " --report " + made(backend).string() +
                                          ".html");
}

// One test instead of two, because two in parallel would compare files that are still being written. Both back
// ends link the same driver, so a difference would be a fault of poinsot.
TEST(GoldenSuite, MatchesItsReferencesOnEveryBackEnd) {
  for (const std::string& backend : backEndNames()) {
    const ShellResult run = runSuite(backend);
    EXPECT_EQ(run.exitCode, 0) << run.out;
  }
  for (const std::string& backEnd : backEndNames()) {
    const ShellResult same =
        runShell(POINSOT_SOURCE_DIR, "diff -r " + made(backEndNames()[0]).string() + " " + made(backEnd).string());
    EXPECT_EQ(same.exitCode, 0) << same.out;
  }
}

}  // namespace
}  // namespace poinsot
