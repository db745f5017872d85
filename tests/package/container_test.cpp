// SPDX-License-Identifier: Apache-2.0
// Building an image takes a registry and minutes. This test only checks that the files named in its recipe exist.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;

std::string in(const std::string& script) { return runShell(POINSOT_SOURCE_DIR, script).out; }

class Recipe : public ::testing::TestWithParam<const char*> {};

TEST_P(Recipe, InstallsTheDebThatPoinsotPackageBuilds) {
  const std::string text = in(std::string("cat packaging/") + GetParam());
  EXPECT_THAT(text, HasSubstr("./poinsot package"));
  EXPECT_THAT(text, HasSubstr("/poinsot/build/poinsot_*.deb"));
  EXPECT_THAT(text, HasSubstr("debian:12-slim"));
  EXPECT_EQ(in("test -x tools/package && echo there"), "there\n");
}

INSTANTIATE_TEST_SUITE_P(Each, Recipe, ::testing::Values("Containerfile", "poinsot.def"), [](const auto& test) {
  return std::string(test.param[0] == 'C' ? "Container" : "Apptainer");
});

}  // namespace
}  // namespace poinsot
