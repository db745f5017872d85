// SPDX-License-Identifier: Apache-2.0
// Uses poinsot inside a user's project, by add_subdirectory() and by FetchContent. Checks what poinsot requires,
// what it would build, and what it leaves unchanged. within_project_nightly_test.cpp builds it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// Shell line that hides pkg-config, and CMake options that hide the libraries needed only for pictures.
const std::string kBare = "export PKG_CONFIG=/nonexistent\n";
const std::string kWithoutPictures =
    "-DPOINSOT_GLAD=/nonexistent -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON "
    "-DCMAKE_DISABLE_FIND_PACKAGE_glm=ON -DCMAKE_CXX_COMPILER=" POINSOT_CXX;

/// Pattern of the libraries that physics does not use.
const std::string kOthers =
    "poinsot_(geometry|image|gl|draw|text|process|scene|stage|render|figure|output|request|compare|"
    "describe|job|suite|reference|cluster|preview|cli|guard)";

class Layers : public ::testing::Test {
 protected:
  std::string run(const std::string& script) const {
    const auto result = runShell(folder_.path(), "set -euo pipefail\n" + script);
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }

  ScratchFolder folder_;
};

class WithinProject : public Layers, public ::testing::WithParamInterface<const char*> {
 protected:
  void configure(const std::string& how) {
    run(kBare + "cmake -G Ninja -S " POINSOT_SOURCE_DIR "/tests/consumer/motion -B b -DHOW=" + how +
        " -DPOINSOT=" POINSOT_SOURCE_DIR " " + kWithoutPictures + " >log 2>&1 || { cat log; exit 1; }");
  }
};

TEST_P(WithinProject, BuildsOnlyLinkedLayersAndKeepsProjectSettings) {
  configure(GetParam());
  const std::string built = run("ninja -C b -t inputs all | grep '[.]o$'");
  EXPECT_THAT(built, HasSubstr("free_motion.cpp.o"));
  EXPECT_THAT(built, HasSubstr("sha256.cpp.o"));
  EXPECT_THAT(built, Not(ContainsRegex(kOthers)));
  EXPECT_THAT(run("ctest --test-dir b -N"), HasSubstr("Total Tests: 0"));

  EXPECT_EQ(run("grep ^CMAKE_BUILD_TYPE b/CMakeCache.txt"), "CMAKE_BUILD_TYPE:STRING=\n");
  const std::string commands = run("ninja -C b -t commands motion | grep main.cpp.o");
  EXPECT_THAT(commands, Not(ContainsRegex(" -(O|W[^l]|f|march)")));  // flags of poinsot's own sources
  EXPECT_THAT(commands, Not(HasSubstr("-z,now")));
  EXPECT_THAT(run("ninja -C b -t targets all | grep '^motion:'"), HasSubstr("LINKER"));  // not in bin/
  EXPECT_EQ(run("DESTDIR=$PWD/installed cmake --install b >/dev/null; find installed -type f 2>/dev/null || true"),
            "");
}

INSTANTIATE_TEST_SUITE_P(Each, WithinProject, ::testing::Values("subdirectory", "fetch"));

// A build of poinsot alone has the same property.
TEST_F(Layers, NeedOnlyTheirOwnDependencies) {
  run(kBare + "cmake -G Ninja -S " POINSOT_SOURCE_DIR " -B b -DPOINSOT_LAYERS=physics " + kWithoutPictures +
      " >log 2>&1 || { cat log; exit 1; }");
  EXPECT_THAT(run("ninja -C b -t targets all"), Not(ContainsRegex(kOthers)));
}

TEST_F(Layers, RejectUnknownNames) {
  EXPECT_THAT(
      run("cmake -S " POINSOT_SOURCE_DIR " -B b -DPOINSOT_LAYERS=psychics 2>&1 | tr -s ' \\n' ' ' || true"),
      HasSubstr("POINSOT_LAYERS: unknown layer psychics; known layers: core, physics, geometry,"));
}

}  // namespace
}  // namespace poinsot
