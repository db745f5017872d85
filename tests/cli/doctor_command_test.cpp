// SPDX-License-Identifier: Apache-2.0
// Tests `doctor` on this machine, complete and with parts taken away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/back_ends.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

TEST(Doctor, ReportsAWorkingMachineAndItsTestFilm) {
  const ScratchFolder folder;
  const auto result = run(folder, {"doctor"});
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, ContainsRegex("\nok      machine +[0-9]+ CPUs?, "));
  EXPECT_THAT(result.out, ContainsRegex("\nok      test film +one second of film at 1280x720 in [0-9.]+ s\n"));
  EXPECT_THAT(result.out, ContainsRegex("\nok      film h264 +NAME.mp4\n"));
  EXPECT_THAT(result.out, ContainsRegex("\nok      OpenGL " + backEndNames()[0] + " +llvmpipe"));
  EXPECT_TRUE(namesIn(folder.path()).empty());
}

TEST(Doctor, ReportsAnOptionalPartAsAbsent) {
  const ScratchFolder folder;
  const auto result = run(folder, {"doctor"}, Stdout::kFile, {"POINSOT_CACHE=off"});
  EXPECT_EQ(result.exitCode, 0) << result.out;
  EXPECT_THAT(result.out, ContainsRegex("\nabsent  shader cache +none, .*\n.*POINSOT_CACHE"));
}

TEST(Doctor, ExitsWith1IfItCannotRenderAFilm) {
  const ScratchFolder folder;
  const auto result = run(folder, {"doctor"}, Stdout::kFile, {"TMPDIR=/nowhere"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, ContainsRegex("\nBAD     test film +[^\n]*/nowhere"));
  EXPECT_THAT(result.out, HasSubstr("\nok      film h264")) << "and goes on";
}

}  // namespace
}  // namespace poinsot
