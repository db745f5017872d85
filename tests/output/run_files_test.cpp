// SPDX-License-Identifier: Apache-2.0
#include "output/run_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "figure/mark.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

using ::testing::HasSubstr;

class RunFilesTest : public FolderTest {
 protected:
  /// Returns the message that refuses an output; empty if the output is accepted.
  std::string clash(const std::filesystem::path& file, const std::string& role = "-o") {
    return messageOf(core::ErrorKind::kUsage, [&] { files_.claims(file, role); });
  }
  std::string refusal(const std::filesystem::path& file, const FileKind& kind, bool force = false) const {
    return messageOf(core::ErrorKind::kIo, [&] { RunFiles(force).writes(file, "-o", kind); });
  }

  RunFiles files_;
};

TEST_F(RunFilesTest, ComparesFilesAndNotTheSpellingOfPaths) {
  save("scene", "x");
  std::filesystem::create_directory(in("folder"));
  std::filesystem::create_directory_symlink(".", in("link"));
  std::filesystem::create_hard_link(in("scene"), in("second"));
  std::filesystem::create_symlink("scene", in("third"));
  files_.reads(in("scene"), "SCENE");
  for (const char* name : {"scene", "./scene", "folder/../scene", "link/link/scene", "second", "third"})
    EXPECT_EQ(clash(in(name)), "-o " + in(name).native() + " is the same file as SCENE " + in("scene").native() +
                                   ", which this run reads; choose another name");
  EXPECT_EQ(clash(in("folder/scene")), "");
}

TEST_F(RunFilesTest, ComparesFilesThatDoNotExistYet) {
  std::filesystem::create_directory_symlink(".", in("link"));
  files_.claims(in("film"), "-o");
  EXPECT_THAT(clash(in("link/./link/film"), "--trace"), HasSubstr("which this run also writes"));
  EXPECT_THAT(clash(in("none/../film"), "--trace"), HasSubstr("which this run also writes"));
  EXPECT_EQ(clash(in("film.json"), "--trace"), "");
}

// A link that is read is also a file of its own, because an output would replace the link.
TEST_F(RunFilesTest, RecognisesAnInputByItsLinkAndByItsTarget) {
  save("real", "x");
  std::filesystem::create_symlink("real", in("link"));
  files_.reads(in("link"), "SCENE");
  EXPECT_NE(clash(in("link")), "");
  EXPECT_NE(clash(in("real")), "");
}

TEST_F(RunFilesTest, RefusesOutputsThatAnInputPatternMatches) {
  const auto isPng = [](const std::filesystem::path& file) { return file.extension() == ".png"; };
  files_.reads(in("b.png"), "the suite's file");
  files_.claims(in("a.txt"), "--junit");
  files_.readsMatching(isPng, "test.image '*.png'");
  EXPECT_EQ(clash(in("a.png")),
            "-o " + in("a.png").native() +
                " would match test.image '*.png', so the next run would read it; choose another name or folder");
  EXPECT_EQ(clash(in("a.svg")), "");
  EXPECT_THAT(
      messageOf(core::ErrorKind::kUsage, [&] { files_.readsMatching([](const auto&) { return true; }, "'*'"); }),
      HasSubstr("--junit "));
}

TEST_F(RunFilesTest, AppendsTextOnlyToFilesOfTheGivenKind) {
  const FileKind kind{"a NAME.md", [](const std::filesystem::path& file) { return file.extension() == ".md"; }};
  const auto refusal = [&](const std::string& name, bool force = false) {
    return messageOf(core::ErrorKind::kIo, [&] { RunFiles(force).addsTo(in(name), "--markdown", kind); });
  };
  save("a.png", "picture");
  save("a.md", "words");
  save("empty", "");
  std::filesystem::create_symlink("a.md", in("link.md"));
  for (const char* name : {"new", "a.md", "empty", "link.md"}) EXPECT_EQ(refusal(name), "") << name;
  EXPECT_EQ(refusal("a.png"), in("a.png").native() + ": exists and is not a NAME.md; --force adds to it");
  EXPECT_EQ(refusal("a.png", true), "");
  ASSERT_EQ(::mkfifo(in("pipe.md").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe.md", in("piped.md"));
  for (const bool force : {false, true}) {
    for (const char* name : {"pipe.md", "piped.md"})
      EXPECT_THAT(refusal(name, force), HasSubstr("is a pipe; text is added to regular files"));
    EXPECT_THAT(refusal(".", force), HasSubstr("is a folder"));
  }
}

TEST_F(RunFilesTest, InputMayBeNamedTwiceAndAfterOutputs) {
  save("a.png", "x");
  files_.reads(in("a.png"), "REFERENCE");
  files_.reads(in("a.png"), "TEST");
  files_.reads("", "--mask");
  files_.claims(in("map.png"), "--map");
  EXPECT_THAT(messageOf(core::ErrorKind::kUsage, [&] { files_.reads(in("map.png"), "--mask"); }),
              HasSubstr("--map " + in("map.png").native() + " is the same file as --mask"));
}

TEST_F(RunFilesTest, ReservesEveryFrameOfASequence) {
  files_.writes(FramePattern(in("f_{frame:03}.png")), 0, 9, "-o");
  EXPECT_NE(clash(in("f_007.png"), "--manifest"), "");
  EXPECT_EQ(clash(in("f_010.png"), "--manifest"), "");
}

TEST_F(RunFilesTest, ReplacesFilesOfTheSameKindOnly) {
  const FileKind trace = textKind("a trace", "{\"trace\""), page = markedKind("a report", figure::kHtmlMark);
  save("trace", "{\"trace\":1}");
  save("page", figure::marked(figure::kHtmlMark, "<p>"));
  save("edited", figure::marked(figure::kHtmlMark, "<p>") + "mine");
  save("empty", "");
  EXPECT_EQ(refusal(in("trace"), trace), "");
  EXPECT_EQ(refusal(in("empty"), trace), "");
  EXPECT_EQ(refusal(in("page"), page), "");
  EXPECT_EQ(refusal(in("page"), trace), in("page").native() +
                                            ": exists and was not written by poinsot as a trace; "
                                            "--force replaces it");
  for (const char* name : {"trace", "edited", "empty"}) {
    EXPECT_THAT(refusal(in(name), page), HasSubstr("as a report")) << name;
    EXPECT_EQ(refusal(in(name), page, true), "") << name;
    EXPECT_THAT(refusal(in(name), {}), HasSubstr("already exists")) << name;
  }
}

}  // namespace
}  // namespace poinsot::output
