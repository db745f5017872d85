// SPDX-License-Identifier: Apache-2.0
// Checks the effect of the flags in cmake/CompilerFlags.cmake on the program with readelf.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string readelf(const std::string& options) {
  const ScratchFolder folder;
  const ShellResult result = runShell(folder.path(), "readelf -W " + options + " " POINSOT_PROGRAM);
  EXPECT_EQ(result.exitCode, 0) << result.out;
  return result.out;
}

TEST(Hardening, ProgramIsPositionIndependent) { EXPECT_THAT(readelf("-h"), ContainsRegex("Type: +DYN")); }

TEST(Hardening, RelocationsAreReadOnly) {
  EXPECT_THAT(readelf("-l"), HasSubstr("GNU_RELRO"));
  EXPECT_THAT(readelf("-d"), ContainsRegex("FLAGS.*NOW"));
}

TEST(Hardening, StackIsNotExecutable) { EXPECT_THAT(readelf("-l"), ContainsRegex("GNU_STACK.* RW  ")); }

TEST(Hardening, StackAndStringsAreGuarded) {
#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
  GTEST_SKIP() << "not of a build with sanitizers or without optimisation";
#endif
  const std::string symbols = readelf("--dyn-syms");
  EXPECT_THAT(symbols, HasSubstr("__stack_chk_fail"));
  EXPECT_THAT(symbols, ContainsRegex("__[a-z]+_chk@"));
  EXPECT_THAT(symbols, HasSubstr("__glibcxx_assert_fail"));
}

}  // namespace
}  // namespace poinsot
