// SPDX-License-Identifier: Apache-2.0
// Builds examples/, as a project of a user, from the installed tree in both ways, and tests/consumer/golden, a
// project with golden tests. Checks the numbers and pictures of the examples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <regex>
#include <sstream>

#include "image/png_file.h"
#include "package/euler_steps.h"
#include "package/installed_tree.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kExamples = POINSOT_SOURCE_DIR "/examples";
const std::string kMotionProject = POINSOT_SOURCE_DIR "/tests/consumer/motion";
const std::string kGoldenProject = POINSOT_SOURCE_DIR "/tests/consumer/golden";

/// Returns the moments of the hammer in examples/trajectory.cpp by textbook formulas. It is a rod of 0.15 kg, 30
/// cm long and 2.4 cm thick. On its end, 15 cm from its middle, is a block of 0.5 kg, 12 cm along y and 3 cm along
/// x and z.
Vector hammerMoments() {
  const double rod = 0.15, block = 0.5, apart = rod * block / (rod + block) * 0.15 * 0.15;
  const double across = rod * (3 * 0.012 * 0.012 + 0.3 * 0.3) / 12 + apart;
  return {across + block * (0.12 * 0.12 + 0.03 * 0.03) / 12, across + block * (0.03 * 0.03 + 0.03 * 0.03) / 12,
          rod * 0.012 * 0.012 / 2 + block * (0.03 * 0.03 + 0.12 * 0.12) / 12};
}

/// Compares every row of the table with the equations of motion, integrated here. The numbers of the table have
/// four and two decimals. The angle is between y and L in body axes, whose components are I omega.
void expectHammer(const std::string& table) {
  const Vector I = hammerMoments();
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  Vector moments{};
  ASSERT_EQ(std::sscanf(line.c_str(), "moments %lf %lf %lf kg", moments.data(), &moments[1], &moments[2]), 3)
      << table;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moments[k], I[k], 5e-7 * I[k]) << k;
  std::getline(lines, line);
  Vector omega{0.1, 8, 0.1};
  for (int row = 0; row <= 12; ++row) {
    double t = 0, angle = 0;
    Vector told{};
    ASSERT_TRUE(lines >> t >> told[0] >> told[1] >> told[2] >> angle) << table;
    EXPECT_EQ(t, 0.25 * row);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(told[k], omega[k], 6e-5) << "t = " << t;
    const double L = std::hypot(I[0] * omega[0], I[1] * omega[1], I[2] * omega[2]);
    EXPECT_NEAR(angle, std::acos(I[1] * omega[1] / L) * 180 / std::numbers::pi, 6e-3) << "t = " << t;
    for (int step = 0; step < 2500; ++step) omega = stepped(I, omega, 1e-4);
  }
}

std::string firstLinesIndented(const std::string& text, int count) {
  std::istringstream lines(text);
  std::string quoted;
  for (std::string line; count-- > 0 && std::getline(lines, line);) quoted += "    " + line + "\n";
  return quoted;
}

/// Expects both examples to work. Their picture must equal the program's picture of the same scene to the last
/// pixel.
void expectWorks(const InstalledTree& tree, const std::string& place) {
  const std::string table = tree.run(place + "/trajectory");
  expectHammer(table);
  EXPECT_THAT(textOf(POINSOT_SOURCE_DIR "/docs/library.md"), HasSubstr(firstLinesIndented(table, 7)));
  EXPECT_THAT(tree.run(place + "/picture book.png"), HasSubstr("book.png, drawn with "));
  tree.run("sed -n '/R\"(/,/)\"/p' " + kExamples +
           "/picture.cpp | sed '1d;$d' >book.toml\n"
           "$PREFIX/bin/poinsot still book.toml --time 2.5 --size 640x360 --quiet -o still.png");
  EXPECT_EQ(image::readPng(tree.folder() / "book.png"), image::readPng(tree.folder() / "still.png"));
}

TEST(Consumer, IsBuiltByCMake) {
  const InstalledTree tree;
  tree.run("cmake -G Ninja -S " + kExamples +
           " -B consumer -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX -DCMAKE_CXX_FLAGS=\"$FLAGS\"\n"
           "cmake --build consumer -j 1");
  expectWorks(tree, "consumer");
}

std::string unindented(const std::string& text) { return std::regex_replace(text, std::regex("(^|\n) +"), "$1"); }

TEST(Consumer, MotionProjectMatchesTheLibraryPage) {
  const std::string page = textOf(POINSOT_SOURCE_DIR "/docs/library.md"), mark = "```cpp\n";
  const auto begin = page.find(mark) + mark.size();
  const std::string shown = page.substr(begin, page.find("```", begin) - begin);
  EXPECT_THAT(shown, HasSubstr("PrincipalMoments(1, 2, 2.5)"));
  EXPECT_THAT(unindented(textOf(kMotionProject + "/main.cpp")), HasSubstr(unindented(shown)));
}

TEST(Consumer, MotionProjectIsBuiltByCMakeAndByPkgConfig) {
  const InstalledTree tree;
  tree.run("cmake -G Ninja -S " + kMotionProject +
           " -B motion -DHOW=package -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX "
           "-DCMAKE_CXX_FLAGS=\"$FLAGS\"\n"
           "cmake --build motion -j 1\n"
           "$CXX $FLAGS -std=c++20 -o by_pkg_config " +
           kMotionProject + "/main.cpp $(pkg-config --cflags --libs poinsot-physics)");
  expectEulersMotion(tree.run("motion/motion"));
  EXPECT_EQ(tree.run("./by_pkg_config"), tree.run("motion/motion"));
}

int goldenTests(const InstalledTree& tree) {
  return std::stoi(tree.run("ctest --test-dir consumer -L golden >ctest.log 2>&1 && echo 0 || echo 1"));
}

// Golden tests of a project, with the program alone: nothing approved, approved, passed, changed.
TEST(Consumer, HasGoldenTests) {
  const InstalledTree tree;
  tree.run(
      "rm -r $PREFIX/include $PREFIX/lib\n"  // as in the program's .deb
      "cp -r " +
      kGoldenProject + " .\n");
  tree.run("CI= cmake -G Ninja -S golden -B consumer -DCMAKE_PREFIX_PATH=$PREFIX");
  EXPECT_EQ(goldenTests(tree), 1);
  EXPECT_THAT(
      tree.run("CI= cmake --build consumer --target poinsot_golden_update"),
      AllOf(HasSubstr("approved/spin.png: approved as the first"), HasSubstr("approved/drawn.png: approved")));
  EXPECT_EQ(goldenTests(tree), 0) << tree.run("cat ctest.log");
  EXPECT_THAT(tree.run("cat consumer/golden/spin/junit.xml"), HasSubstr("failures=\"0\""));
  // If a picture is no longer drawn, the picture of an earlier run does not count.
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
  tree.run("$CXX $FLAGS -std=c++20 -o trajectory " + kExamples +
           "/trajectory.cpp $(pkg-config --cflags --libs poinsot-physics)\n"
           "$CXX $FLAGS -std=c++20 -o picture " +
           kExamples + "/picture.cpp $(pkg-config --cflags --libs poinsot-stage poinsot-render poinsot-output)");
  expectWorks(tree, ".");
  // If the file cannot be written, the example prints an error and ends with 1.
  EXPECT_THAT(tree.run("./picture no/such/folder.png 2>&1 || echo $?"),
              AllOf(HasSubstr("no/such"), HasSubstr("\n1\n")));
}

// FFmpeg is needed where a program reads films, not where it is built.
TEST(Consumer, LinksNoFfmpeg) {
  const InstalledTree tree;
  tree.folder().put("film.cpp",
                    "#include \"output/film_reader.h\"\n"
                    "int main(int, char** words) { poinsot::output::FilmReader film(words[1]); }\n");
  tree.run(
      "$CXX $FLAGS -std=c++20 -o film film.cpp $(pkg-config --cflags --libs poinsot-output)\n"
      "! readelf --dynamic film | grep NEEDED | grep -e libav -e libsw -e imagequant -e gomp");
}

// In all layers, the includes of every header exist, and pkg-config names third-party libraries.
TEST(Consumer, CompilesEveryPublicHeader) {
  const InstalledTree tree;
  tree.run(
      "cd $PREFIX/include/poinsot\n"
      "find . -name '*.h' -printf '#include \"%P\"\\n' | sort >../../all.cpp\n"
      "(($(wc -l <../../all.cpp) > 50))\n"
      "modules=$(cd $PREFIX/lib/pkgconfig && ls | sed 's/[.]pc$//')\n"
      "$CXX $FLAGS -std=c++20 -fsyntax-only ../../all.cpp $(pkg-config --cflags $modules)\n"
      "! pkg-config --libs $modules | grep ::\n");  // target names of CMake
}

// Without libpng, the physics is available. Pictures are not, and the message gives the reason.
TEST(Consumer, NeedsOnlyDependenciesOfItsLayers) {
  const InstalledTree tree;
  tree.folder().put("CMakeLists.txt",
                    "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n"
                    "find_package(poinsot REQUIRED COMPONENTS physics)\n"
                    "find_package(poinsot COMPONENTS image)\n");
  const std::string told = tree.run(
      "cmake -G Ninja -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX "
      "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON 2>&1 | tr -s ' \\n' ' '");
  EXPECT_THAT(
      told,
      HasSubstr("poinsot could not be found because dependency PNG could not be found (Debian: libpng-dev)"));
}

// A static library needs its own dependencies where it is linked.
TEST(Consumer, FindsAllLayersAndTheirDependencies) {
  const InstalledTree tree;
  tree.folder().put("main.cpp", "int main() {}\n");
  tree.folder().put(
      "CMakeLists.txt",
      "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n"
      "find_package(poinsot REQUIRED)\nadd_executable(p main.cpp)\n"
      "target_link_libraries(p PRIVATE poinsot::cluster poinsot::suite poinsot::preview poinsot::reference)\n");
  tree.run(
      "cmake -G Ninja -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX >log 2>&1 || { cat log; "
      "exit 1; }");
}

// A layer that was not requested still exists as a target; a later find_package() completes it.
TEST(Consumer, GetsTheNameOfAMissingComponent) {
  const InstalledTree tree;
  tree.folder().put("main.cpp", "int main() {}\n");
  const auto configure = [&](const std::string& more) {
    tree.folder().put("CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n"
                      "find_package(poinsot REQUIRED COMPONENTS physics)\nadd_executable(p main.cpp)\n"
                      "target_link_libraries(p PRIVATE poinsot::output)\n" +
                          more);
    return tree.run(
        "cmake -G Ninja -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX -DCMAKE_CXX_COMPILER=$CXX 2>&1 | tr -s ' \\n' ' ' "
        "|| true");
  };
  EXPECT_THAT(configure(""), HasSubstr("poinsot::add_output_to_the_COMPONENTS_of_find_package"));
  const std::string whole = configure("find_package(poinsot REQUIRED COMPONENTS output)\n");
  EXPECT_THAT(whole, AllOf(HasSubstr("Generating done"), Not(HasSubstr("CMake Error"))));
}

TEST(Consumer, GetsAReasonIfAComponentIsNotFound) {
  const InstalledTree tree;
  const auto configure = [&](const std::string& find) {
    tree.folder().put("CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES NONE)\n" + find);
    return tree.run("cmake -S . -B p -DCMAKE_PREFIX_PATH=$PREFIX 2>&1 | tr -s ' \\n' ' ' || true");
  };
  EXPECT_THAT(configure("find_package(poinsot COMPONENTS psychics)"),
              HasSubstr("poinsot has no component psychics; it has: golden, core, physics, geometry, "));
  EXPECT_THAT(configure("find_package(poinsot 9 REQUIRED)"), HasSubstr("requested version"));
  // The components are in separate packages, and each message names the package of the other.
  tree.run("mv $PREFIX/lib lib");
  EXPECT_THAT(configure("find_package(poinsot COMPONENTS physics)"),
              HasSubstr("the libraries are in the Debian package libpoinsot-dev"));
  tree.run("mv lib $PREFIX/lib; rm -r $PREFIX/share/cmake");
  EXPECT_THAT(configure("find_package(poinsot COMPONENTS golden)"),
              HasSubstr("the component golden comes with the program (Debian: poinsot)"));
}

}  // namespace
}  // namespace poinsot
