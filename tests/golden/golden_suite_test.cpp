// SPDX-License-Identifier: Apache-2.0
// The pictures of golden.toml, by the command that others use for theirs. What is not identical is shown by
// build/golden/BACKEND.html.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/back_ends.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

/// Where the new pictures of a back end are.
fs::path made(const std::string& backend) { return fs::path(POINSOT_BINARY_DIR) / "golden" / backend; }

ShellResult runSuite(const std::string& backend) {
  fs::create_directories(made(backend));
  return runShell(POINSOT_SOURCE_DIR, POINSOT_PROGRAM " golden tests/golden/golden.toml --backend " + backend +
                                          " -o " + made(backend).string() + " --report " + made(backend).string() +
                                          ".html");
}

// One test: two at a time would have the second look at what the first is still making. Both back ends link the
// same driver; what differs would be ours.
TEST(GoldenSuite, LooksAsItDidAndHasTheSameBytesOnEgl) {
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
