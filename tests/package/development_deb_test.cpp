// SPDX-License-Identifier: Apache-2.0
// Tests libpoinsot-dev, unpacked without any other part of poinsot, with pkg-config and with CMake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "package/euler_steps.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class DevelopmentDeb : public ::testing::Test {
 protected:
  std::string run(const std::string& script) const {
    const auto result =
        runShell(folder_.path(), "set -euo pipefail\n" + script, {"CXX=" POINSOT_CXX, "FLAGS=" POINSOT_CXX_FLAGS});
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }

  std::string field(const std::string& name) const { return run("dpkg-deb -f libpoinsot-dev.deb " + name); }

  ScratchFolder folder_;
};

// There is one test, because packing takes seconds.
TEST_F(DevelopmentDeb, NamesItsDependenciesAndBuildsTheExamples) {
  run("cpack -G DEB --config " POINSOT_BINARY_DIR
      "/CPackConfig.cmake -B $PWD -D CPACK_COMPONENTS_ALL=development -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip "
      ">cpack.log || { cat cpack.log; exit 1; }\n"
      "mv libpoinsot-dev_*_*.deb libpoinsot-dev.deb && dpkg-deb -x libpoinsot-dev.deb root");
  EXPECT_EQ(field("Package"), "libpoinsot-dev\n");
  EXPECT_EQ(field("Section"), "libdevel\n");
  // The physics alone needs neither FFmpeg nor Mesa.
  EXPECT_EQ(run("dpkg-deb -f libpoinsot-dev.deb Depends | sed 's/, /\\n/g' | sort"),
            "libeigen3-dev\nlibfmt-dev\nlibssl-dev\n");
  const std::string recommended = field("Recommends");
  EXPECT_THAT(recommended, AllOf(HasSubstr("libpng-dev"), HasSubstr("libosmesa6 | libegl1"),
                                 HasSubstr("libavcodec"), Not(HasSubstr("libeigen3-dev"))));
  // Oracle: this build used these packages.
  run("wanted=$(dpkg-deb -f libpoinsot-dev.deb Depends Recommends | sed 's/^[A-Za-z]*: //' | tr -d ' ' | tr ',' "
      "'\\n')\n"
      "(($(wc -w <<<$wanted) > 15))\n"
      "for one in $wanted; do\n"
      "  [[ $(dpkg-query -W ${one//|/ } 2>/dev/null || true) ]] || { echo $one; exit 1; }\n"
      "done");

  // Debian requires the package's own notices, no separate licence file, no file that others may write, and no
  // executable file.
  run("cd root/usr/share/doc/libpoinsot-dev && gzip -t changelog.gz && test -s copyright");
  EXPECT_EQ(run("find root -type f -perm /133"), "");
  EXPECT_EQ(run("find root -type f -path '*/share/*' -printf '%P\\n' | sort"),
            "usr/share/doc/libpoinsot-dev/changelog.gz\nusr/share/doc/libpoinsot-dev/copyright\n"
            "usr/share/poinsot/lsan.supp\nusr/share/poinsot/tsan.supp\n");
  EXPECT_EQ(run("grep -rlF " POINSOT_BINARY_DIR " root || true"), "") << "paths of the build";

  run("$CXX $FLAGS -std=c++20 -o trajectory " POINSOT_SOURCE_DIR
      "/examples/trajectory.cpp $(PKG_CONFIG_PATH=root/usr/lib/pkgconfig pkg-config --cflags --libs "
      "poinsot-physics)");
  EXPECT_THAT(run("./trajectory"), HasSubstr("0.50    2.2109    7.5763    2.4224           18.75"));
  run("cmake -G Ninja -S " POINSOT_SOURCE_DIR
      "/tests/consumer/motion -B motion -DHOW=package -DCMAKE_PREFIX_PATH=$PWD/root/usr -DCMAKE_CXX_COMPILER=$CXX "
      "-DCMAKE_CXX_FLAGS=\"$FLAGS\" >log 2>&1 && cmake --build motion >>log 2>&1 || { cat log; exit 1; }");
  expectEulersMotion(run("motion/motion"));
}

}  // namespace
}  // namespace poinsot
