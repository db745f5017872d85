// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "image/png_file.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

/// The package, made in a scratch folder and unpacked in root/.
class Deb : public ::testing::Test {
 protected:
  void SetUp() override {
    run("cpack -G DEB --config " POINSOT_BINARY_DIR
        "/CPackConfig.cmake -B $PWD >cpack.log || { cat cpack.log; exit 1; }\n"
        "mv poinsot_*_*.deb poinsot.deb && dpkg-deb -x poinsot.deb root");
  }

  std::string run(const std::string& script) const {
    const auto result = runShell(folder_.path(), "set -euo pipefail\n" + script);
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }

  std::string field(const std::string& name) const { return run("dpkg-deb -f poinsot.deb " + name); }

  ScratchFolder folder_;
};

/// The words of an array of the launcher.
std::vector<std::string> launcherList(const std::string& name) {
  const auto result =
      runShell(POINSOT_SOURCE_DIR, "source <(sed -n '/^" + name + "=(/,/)/p' poinsot); echo ${" + name + "[@]}");
  std::istringstream words(result.out);
  return {std::istream_iterator<std::string>(words), {}};
}

// One package takes a second or two to make; so this is one test.
TEST_F(Deb, SaysWhatItNeedsAndRendersWhereItIsUnpacked) {
  EXPECT_EQ(field("Package"), "poinsot\n");
  EXPECT_THAT(field("Version"), MatchesRegex("[0-9.]+\n"));
  const std::string depends = field("Depends");
  for (const char* linked : {"libc6", "libstdc++6", "libcairo2", "libfmt9"})
    EXPECT_THAT(depends, HasSubstr(linked));
  // Opened when a film is made: no linker says so. Oracle: the packages that the libraries of the headers lie in.
  for (const char* name : {"libavformat", "libavcodec", "libavutil", "libswscale", "libimagequant"}) {
    const std::string package = run("dpkg-query -S /usr/lib/*/" + std::string(name) + ".so.? /usr/lib/*/" + name +
                                    ".so.?? 2>/dev/null | head -n 1 | sed 's/:.*//' | tr -d '\\n' || true");
    EXPECT_THAT(package, StartsWith(name));
    EXPECT_THAT(depends, HasSubstr(package));
  }
  const auto opened = launcherList("packages_run");  // at run time, so that no linker says so
  EXPECT_FALSE(opened.empty());
  for (const std::string& package : opened) EXPECT_THAT(depends, HasSubstr(package));
  EXPECT_THAT(depends, HasSubstr("libosmesa6 | libegl1"));

  EXPECT_EQ(run("find root -path '*/include/*' -o -name '*.a' -o -perm /022 -type f"), "")
      << "no development files";
  run("file root/usr/bin/poinsot | grep -q ' stripped'");
  run("gzip -cd root/usr/share/man/man1/poinsot-render.1.gz | grep -q '^.TH POINSOT'");

  run("root/usr/bin/poinsot render root/usr/share/poinsot/scenes/football.toml --frames 0-2 --size 96x54 -j 1 "
      "--quiet -o film.mp4 && root/usr/bin/poinsot still root/usr/share/poinsot/scenes/football.toml --size 96x54 "
      "--quiet -o still.png");
  EXPECT_GT(std::filesystem::file_size(folder_ / "film.mp4"), 1000u);
  EXPECT_EQ(image::readPng(folder_ / "still.png").size, (image::PixelSize{96, 54}));
}

}  // namespace
}  // namespace poinsot
