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
using ::testing::Not;
using ::testing::StartsWith;

// development_deb_test.cpp tests the third component.
#ifdef POINSOT_PYTHON_PACKAGE
constexpr const char* kComponents = "program;python";
#else
constexpr const char* kComponents = "program";
#endif

class Deb : public ::testing::Test {
 protected:
  void SetUp() override {
    run("cpack -G DEB --config " POINSOT_BINARY_DIR "/CPackConfig.cmake -B $PWD -D 'CPACK_COMPONENTS_ALL=" +
        std::string(kComponents) +
        "' >cpack.log || { cat cpack.log; exit 1; }\n"
        "mv poinsot_*_*.deb poinsot.deb && dpkg-deb -x poinsot.deb root\n"
        "! ls python3-poinsot_*_*.deb 2>/dev/null || mv python3-poinsot_*_*.deb python3-poinsot.deb");
  }

  std::string run(const std::string& script) const {
    const auto result = runShell(folder_.path(), "set -euo pipefail\n" + script);
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }

  std::string field(const std::string& name, const std::string& package = "poinsot") const {
    return run("dpkg-deb -f " + package + ".deb " + name);
  }

  ScratchFolder folder_;
};

std::vector<std::string> launcherList(const std::string& purpose) {
  const auto result = runShell(POINSOT_SOURCE_DIR, "sed -n 's/^" + purpose + ": //p' packaging/debian.txt");
  std::istringstream words(result.out);
  return {std::istream_iterator<std::string>(words), {}};
}

// There is one test, because a package takes a second or two to build.
TEST_F(Deb, NamesItsDependenciesAndRendersWhenUnpacked) {
  EXPECT_EQ(field("Package"), "poinsot\n");
  EXPECT_THAT(field("Version"), MatchesRegex("[0-9.]+\n"));
  const std::string depends = field("Depends");
  for (const char* linked : {"libc6", "libstdc++6", "libcairo2", "libfmt"}) EXPECT_THAT(depends, HasSubstr(linked));
  // Libraries that are opened when a film is made are recommended only. Oracle: the packages that contain them.
  const std::string recommends = field("Recommends");
  for (const char* name : {"libavformat", "libavcodec", "libavutil", "libswscale", "libimagequant"}) {
    const std::string package = run("dpkg-query -S /usr/lib/*/" + std::string(name) + ".so.? /usr/lib/*/" + name +
                                    ".so.?? 2>/dev/null | head -n 1 | sed 's/:.*//' | tr -d '\\n' || true");
    EXPECT_THAT(package, StartsWith(name));
    EXPECT_THAT(recommends, HasSubstr(package));
    EXPECT_THAT(depends, Not(HasSubstr(package)));
  }
  const auto opened = launcherList("run");
  EXPECT_FALSE(opened.empty());
  for (const std::string& package : opened)  // NAME? is optional: a dependency only if the system has it
    EXPECT_THAT(recommends, HasSubstr(package.substr(0, package.find('?'))));
  EXPECT_THAT(recommends, HasSubstr("libosmesa6 | libegl1"));

  EXPECT_EQ(run("find root -path '*/include/*' -o -name '*.a' -o -perm /022 -type f"), "")
      << "no development files";
  run("file root/usr/bin/poinsot | grep -q ' stripped'");
  run("gzip -cd root/usr/share/man/man1/poinsot-render.1.gz | grep -q '^.TH POINSOT'");

  run("root/usr/bin/poinsot render root/usr/share/poinsot/scenes/football.toml --frames 0-2 --size 96x54 -j 1 "
      "--quiet -o film.mp4 && root/usr/bin/poinsot still root/usr/share/poinsot/scenes/football.toml --size 96x54 "
      "--quiet -o still.png");
  EXPECT_GT(std::filesystem::file_size(folder_ / "film.mp4"), 1000u);
  EXPECT_EQ(image::readPng(folder_ / "still.png").size, (image::PixelSize{96, 54}));

#ifdef POINSOT_PYTHON_PACKAGE
  EXPECT_EQ(field("Package", "python3-poinsot"), "python3-poinsot\n");
  std::string version = field("Version");
  version.pop_back();
  EXPECT_THAT(field("Depends", "python3-poinsot"), HasSubstr("python3-numpy, poinsot (= " + version + ")"));
  // The Python package finds the program on the PATH, as an installed one.
  run("dpkg-deb -x python3-poinsot.deb root\n"
      "cat >try.py <<'END'\n"
      "import poinsot\n"
      "scene = poinsot.load('root/usr/share/poinsot/scenes/football.toml')\n"
      "assert '/root/usr/lib/' in poinsot.__file__, poinsot.__file__\n"
      "assert scene.render(size=(96, 54)).shape == (54, 96, 3)\n"
      "scene.film('python.mp4', size=(96, 54), frames=(0, 2), jobs=1)\n"
      "END\n"
      "PATH=$PWD/root/usr/bin:$PATH PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 -B try.py\n"
      "cmp film.mp4 python.mp4");
  // Pages link to one another and to the examples, which run in their folder.
  run("cd root/usr/share/doc/python3-poinsot\n"
      "for page in README.md python.md; do\n"
      "  for link in $(grep -o '](\\([^)#]*\\)' $page | cut -c3-); do ls -d $link >/dev/null; done\n"
      "done\n"
      "ls examples/lecture15.ipynb");
  run("PATH=$PWD/root/usr/bin:$PATH PYTHONPATH=root/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 "
      "root/usr/share/doc/python3-poinsot/examples/compare_pictures.py | grep '^again *identical'");
  for (const char* used : {"python3-pandas", "python3-scipy", "python3-pil"})
    EXPECT_THAT(field("Suggests", "python3-poinsot"), HasSubstr(used));
#endif
}

}  // namespace
}  // namespace poinsot
