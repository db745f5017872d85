// SPDX-License-Identifier: Apache-2.0
// tests/consumer, a project of somebody else's, built from the installed tree both ways, with golden tests of its
// own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/png_file.h"
#include "package/installed_tree.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kConsumer = POINSOT_SOURCE_DIR "/tests/consumer";

/// Both programs of the consumer work, wherever they were built.
void expectWorks(const InstalledTree& tree, const std::string& place) {
  EXPECT_EQ(tree.run(place + "/spin"), "energy after 1e6 s: kept\n");
  EXPECT_THAT(tree.run(place + "/picture picture.png"), HasSubstr("drawn with "));
  const auto picture = image::readPng(tree.folder() / "picture.png");
  EXPECT_EQ(picture.size, (image::PixelSize{320, 180}));
  EXPECT_NE(std::vector<int>(picture.at(160, 90), picture.at(160, 90) + 3),
            std::vector<int>(picture.at(2, 2), picture.at(2, 2) + 3))
      << "a body before the paper";
}

TEST(Consumer, IsBuiltByCMake) {
  const InstalledTree tree;
  tree.run("cmake -G Ninja -S " + kConsumer +
           " -B consumer -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX -DCMAKE_CXX_FLAGS=\"$FLAGS\"\n"
           "cmake --build consumer -j 1");
  expectWorks(tree, "consumer");
}

/// The exit code of its golden tests.
int goldenTests(const InstalledTree& tree) {
  return std::stoi(tree.run("ctest --test-dir consumer -L golden >ctest.log 2>&1 && echo 0 || echo 1"));
}

// Nothing approved, approved, passed, changed: by what a project writes of its own, with the program alone.
TEST(Consumer, HasGoldenTests) {
  const InstalledTree tree;
  tree.run(
      "rm -r $PREFIX/include $PREFIX/lib/*.a $PREFIX/lib/cmake/poinsot/poinsotTargets*\n"  // as in the .deb
      "cp -r " +
      kConsumer + "/golden .\n");
  tree.run("CI= cmake -G Ninja -S golden -B consumer -DCMAKE_PREFIX_PATH=$PREFIX");
  EXPECT_EQ(goldenTests(tree), 1);
  EXPECT_THAT(
      tree.run("CI= cmake --build consumer --target poinsot_golden_update"),
      AllOf(HasSubstr("approved/spin.png: approved, the first"), HasSubstr("approved/drawn.png: approved")));
  EXPECT_EQ(goldenTests(tree), 0) << tree.run("cat ctest.log");
  EXPECT_THAT(tree.run("cat consumer/golden/spin/junit.xml"), HasSubstr("failures=\"0\""));
  // A picture of an earlier run does not stand for one that is not drawn any more.
  tree.run("mv golden/draw.sh draw.sh; printf '#!/bin/sh\\n' >golden/draw.sh; chmod +x golden/draw.sh");
  EXPECT_EQ(goldenTests(tree), 1);
  tree.run("mv draw.sh golden/draw.sh");
  EXPECT_EQ(goldenTests(tree), 0);
  tree.run("sed -i 's/200/180/' golden/draw.sh");
  EXPECT_EQ(goldenTests(tree), 1);
  EXPECT_THAT(tree.run("cat ctest.log"), AllOf(HasSubstr("drawn (Failed)"), Not(HasSubstr("spin (Failed)"))));
}

TEST(Consumer, IsBuiltByPkgConfig) {
  const InstalledTree tree;
  tree.run("$CXX $FLAGS -std=c++20 -o spin " + kConsumer +
           "/spin.cpp $(pkg-config --static --cflags --libs poinsot-physics)\n"
           "$CXX $FLAGS -std=c++20 -o picture " +
           kConsumer + "/picture.cpp $(pkg-config --cflags --libs poinsot-stage poinsot-render)");
  expectWorks(tree, ".");
}

// Who reads films needs FFmpeg where they are read, not where the program is built.
TEST(Consumer, LinksNoFfmpeg) {
  const InstalledTree tree;
  tree.folder().put("film.cpp",
                    "#include \"output/film_reader.h\"\n"
                    "int main(int, char** words) { poinsot::output::FilmReader film(words[1]); }\n");
  tree.run(
      "$CXX $FLAGS -std=c++20 -o film film.cpp $(pkg-config --cflags --libs poinsot-output)\n"
      "! readelf --dynamic film | grep NEEDED | grep -e libav -e libsw -e imagequant -e gomp");
}

// Of all layers: what a header includes is there, and its third parties are named.
TEST(Consumer, EveryPublicHeaderIsWhole) {
  const InstalledTree tree;
  tree.run(
      "cd $PREFIX/include/poinsot\n"
      "find . -name '*.h' -printf '#include \"%P\"\\n' | sort >../../all.cpp\n"
      "(($(wc -l <../../all.cpp) > 50))\n"
      "modules=$(cd $PREFIX/lib/pkgconfig && ls | sed 's/[.]pc$//')\n"
      "$CXX $FLAGS -std=c++20 -fsyntax-only ../../all.cpp $(pkg-config --cflags $modules)\n"
      "pkg-config --libs $modules >/dev/null");
}

// The physics is to be had where there is no libpng; pictures are not, and it is said
// why.
TEST(Consumer, NeedsOnlyWhatItsLayersNeed) {
  const InstalledTree tree;
  tree.folder().put("CMakeLists.txt",
                    "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n"
                    "find_package(poinsot REQUIRED COMPONENTS physics)\n"
                    "find_package(poinsot COMPONENTS image)\n");
  const std::string told = tree.run(
      "cmake -G Ninja -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX "
      "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON 2>&1 | tr -s ' \\n' ' '");
  EXPECT_THAT(told, HasSubstr("poinsot could not be found because dependency PNG could not be found"));
}

TEST(Consumer, IsToldWhatIsWrong) {
  const InstalledTree tree;
  const auto configure = [&](const std::string& find) {
    tree.folder().put("CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES NONE)\n" + find);
    return tree.run("cmake -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX 2>&1 | tr -s ' \\n' ' ' || true");
  };
  EXPECT_THAT(configure("find_package(poinsot COMPONENTS psychics)"),
              HasSubstr("poinsot has no component psychics; it has: golden core"));
  EXPECT_THAT(configure("find_package(poinsot 9 REQUIRED)"), HasSubstr("requested version"));
}

}  // namespace
}  // namespace poinsot
