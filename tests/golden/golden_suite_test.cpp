// SPDX-License-Identifier: Apache-2.0
// The pictures of golden.toml, by the command that others use for theirs. What is not identical is shown by
// build/golden/BACKEND.html.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/shell_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

/// Where the new pictures of a back end are.
fs::path made(const std::string& backend) { return fs::path(POINSOT_BINARY_DIR) / "golden" / backend; }

ShellResult runSuite(const std::string& backend, const std::string& more = "") {
  fs::create_directories(made(backend));
  return runShell(POINSOT_SOURCE_DIR, POINSOT_PROGRAM " golden tests/golden/golden.toml --backend " + backend +
                                          " -o " + made(backend).string() + " --report " + made(backend).string() +
                                          ".html" + more);
}

TEST(GoldenSuite, LooksAsItDid) {
  const ShellResult run = runSuite("osmesa");
  EXPECT_EQ(run.exitCode, 0) << run.out;
}

// Both link the same driver; what differs would be ours.
TEST(GoldenSuite, HasTheSameBytesOnEgl) {
  const ShellResult run = runSuite("egl");
  EXPECT_EQ(run.exitCode, 0) << run.out;
  if (!fs::exists(made("osmesa"))) runSuite("osmesa");
  const ShellResult same =
      runShell(POINSOT_SOURCE_DIR, "diff -r " + made("osmesa").string() + " " + made("egl").string());
  EXPECT_EQ(same.exitCode, 0) << same.out;
}

}  // namespace
}  // namespace poinsot
