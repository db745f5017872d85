// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "package/installed_tree.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(InstalledProgram, FindsTheScenesInstalledWithIt) {
  const InstalledTree tree;
  const std::string list = tree.run("unset POINSOT_SCENES; $PREFIX/bin/poinsot gallery --dry-run --only football");
  EXPECT_THAT(list, HasSubstr(tree.prefix().string() + "/share/poinsot/scenes/football.toml"));
}

TEST(InstalledProgram, IncludesManualCompletionsAndLicences) {
  const InstalledTree tree;
  for (const char* file : {"share/man/man1/poinsot.1.gz", "share/man/man1/poinsot-render.1.gz",
                           "share/bash-completion/completions/poinsot", "share/zsh/vendor-completions/_poinsot",
                           "share/fish/vendor_completions.d/poinsot.fish", "share/doc/poinsot/copyright",
                           "share/doc/poinsot/LICENSE", "share/poinsot/scenes/styles/one_ink.toml"})
    EXPECT_TRUE(std::filesystem::is_regular_file(tree.prefix() / file)) << file;
}

// ./poinsot builds only the program, so a whole installation would stop half way.
TEST(InstalledProgram, InstallationFailsIfFilesAreNotBuilt) {
  const ScratchFolder folder;
  const auto install = [&](const std::string& component) {
    return runShell(folder.path(), "sed s/share.stamp/missing/ " POINSOT_BINARY_DIR
                                   "/cmake_install.cmake >install.cmake\n"
                                   "cmake -DCMAKE_INSTALL_PREFIX=$PWD/prefix -DCMAKE_INSTALL_COMPONENT=" +
                                       component +
                                       " -P install.cmake 2>&1 | tr -s ' \\n' ' '; exit ${PIPESTATUS[0]}");
  };
  const auto program = install("program");
  EXPECT_NE(program.exitCode, 0);
  EXPECT_THAT(program.out, HasSubstr("Run ./poinsot package, or cmake --build"));
  EXPECT_FALSE(std::filesystem::exists(folder / "prefix"));
  EXPECT_EQ(install("development").exitCode, 0);
}

// Libraries for films are opened only for films. Otherwise every process would bind over a hundred libraries.
TEST(InstalledProgram, LinksNeitherFfmpegNorImagequant) {
  const InstalledTree tree;
  const std::string linked = tree.run("readelf --dynamic $PREFIX/bin/poinsot | grep NEEDED");
  EXPECT_THAT(linked, HasSubstr("libpng"));
  for (const char* library : {"libav", "libsw", "libimagequant", "libgomp"})
    EXPECT_THAT(linked, Not(HasSubstr(library)));
}

// A path of the build is useless on another machine, or names another file there.
TEST(InstalledProgram, ContainsNoPathOfTheBuild) {
  const InstalledTree tree;
  // Debug information may contain such paths.
  tree.run("find $PREFIX -name '*.a' -o -path '*/bin/poinsot' | xargs strip -g");
  EXPECT_EQ(tree.run("grep -rl -e " POINSOT_BINARY_DIR " -e " POINSOT_SOURCE_DIR " $PREFIX || true"), "");
}

}  // namespace
}  // namespace poinsot
