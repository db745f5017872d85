// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ManPages : public ::testing::Test {
 protected:
  void SetUp() override { run(POINSOT_PROGRAM " self-describe share"); }

  std::string run(const std::string& script) const {
    const auto result = runShell(folder_.path(), script);
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }
  std::string shown(const std::string& page) const {
    return run("groff -man -Tascii -P-cbou -rLL=100n share/man/man1/" + page + " | tr -s ' \\n' ' '");
  }

  ScratchFolder folder_;
};

// Oracle: the help. Every command in it has a page, and every option is on that page.
TEST_F(ManPages, HaveEveryCommandAndOptionOfTheHelp) {
  const std::string commands =
      run(POINSOT_PROGRAM " --help | sed -n '/^subcommands:/I,/^[^ ]/s/^  \\([a-z][a-z-]*\\) .*/\\1/p'");
  EXPECT_THAT(commands, HasSubstr("render\n"));
  EXPECT_EQ(run("cd share/man/man1 && ls | sed -n 's/poinsot-\\(.*\\)[.]1/\\1/p' | sort"),
            run("printf '" + commands + "' | sort"));
  for (const std::string command : {"render", "still", "submit", "grade"}) {
    const std::string page = shown("poinsot-" + command + ".1");
    std::istringstream options(
        run(POINSOT_PROGRAM " " + command + " --help | grep -oE '^  -.*' | grep -oE -- '--[a-z-]+'"));
    for (std::string option; options >> option;) EXPECT_THAT(page, HasSubstr(option + " ")) << command;
  }
}

// Oracle: the table of keys in docs/golden.md.
TEST_F(ManPages, ListEveryKeyOfAGoldenToml) {
  const std::string page = shown("poinsot-golden.1");
  std::istringstream keys(run(
      "sed -n '/golden keys -->/,/end -->/s/^| `\\([a-z_]*\\)` .*/\\1/p' " POINSOT_SOURCE_DIR "/docs/golden.md"));
  int count = 0;
  for (std::string key; keys >> key; ++count) EXPECT_THAT(page, ContainsRegex("[ .]" + key + " "));
  EXPECT_GE(count, 24);  // when this test was written
  EXPECT_THAT(page, HasSubstr("KEYS OF MANIFEST references text folder of the approved pictures"));
  EXPECT_THAT(page,
              HasSubstr("rule.pixels \"0-N\" differing pixels, as a number or a percentage (default: 0-0.5%)"));
}

TEST_F(ManPages, AreValidRoff) {
  EXPECT_THAT(run("for page in share/man/man1/*; do groff -ww -b -z -man -Tutf8 $page; done 2>&1"), IsEmpty());
}

TEST_F(ManPages, ShowSynopsisOptionsAndExitStatus) {
  const std::string page = shown("poinsot-render.1");
  EXPECT_THAT(page, HasSubstr("poinsot-render - make a film, a frame or a numbered sequence from a scene"));
  EXPECT_THAT(page, HasSubstr("poinsot render SCENE [OPTION]..."));
  EXPECT_THAT(page, HasSubstr("-j, --jobs N number of worker processes (default: one per CPU); the output does "
                              "not depend on it (1 to 1024)"));
  EXPECT_THAT(page, HasSubstr("--backend NAME OpenGL back end: osmesa, egl, or auto"));
  EXPECT_THAT(page, HasSubstr("-o 'out/frames/football_{frame:05}.png'")) << "quotes as they are to be typed";
  EXPECT_THAT(page, HasSubstr("EXIT STATUS 0 done, 1 the answer is no"));
  EXPECT_THAT(page, HasSubstr("4 files, 129/130/143 signals"));
  EXPECT_THAT(shown("poinsot.1"), HasSubstr("POINSOT_SCENES"));
  EXPECT_THAT(shown("poinsot.1"), Not(HasSubstr("self-describe")));
}

}  // namespace
}  // namespace poinsot
