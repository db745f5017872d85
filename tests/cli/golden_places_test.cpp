// SPDX-License-Identifier: Apache-2.0
// Tests the places of references and new pictures of `poinsot golden` and `diff --update`: no two roles of a suite
// may share one file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/golden_images_fixture.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class GoldenPaths : public GoldenImagesFixture {};

// Otherwise a golden.toml from a stranger could put any picture of the machine into the report.
TEST_F(GoldenPaths, RejectNamesThatLeadOutOfTheReferences) {
  const ScratchFolder elsewhere;
  saveBytes(elsewhere / "secret.png", flat(90));
  const std::string outside = fs::relative(elsewhere.path(), folder_ / "ref").native();
  manifest("[[test]]\nimage = 'nothing/*.png'\nname = '" + outside + "/*'\n");
  const RunResult refused = golden({"--report", "r.html"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err, AllOf(StartsWith("golden.toml:2:1: error: test.name: "),
                                 HasSubstr("must be a relative path of at most 200 printable characters")));
  EXPECT_THAT(refused.out, Not(HasSubstr("secret")));
}

TEST_F(GoldenPaths, RejectLinksAmongTheFoldersOfReferences) {
  const ScratchFolder elsewhere;
  saveBytes(elsewhere / "a.png", flat(90));
  save("new/a.png", flat(90));
  fs::create_directory(folder_ / "ref");
  fs::create_directory_symlink(elsewhere.path(), folder_ / "ref/sub");
  for (const char* image : {"new/*.png", "nothing/*.png"}) {
    manifest("[[test]]\nimage = '" + std::string(image) + "'\nname = 'sub/*'\n");
    EXPECT_THAT(golden().out, Not(HasSubstr("unused"))) << image;  // a.png lies outside the suite
  }
  manifest("[[test]]\nimage = 'new/*.png'\nname = 'sub/*'\n");
  for (const RunResult& refused : {golden(), golden({"--update"})}) {
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.out,
                StartsWith("error      sub/a: ref/sub: is a symbolic link; references must be in real folders "));
  }
  EXPECT_FALSE(fs::exists(elsewhere / "a.json"));

  save("mine/sub/new.png", flat(30));
  const RunResult pairs = poinsot({"diff", "ref", "mine", "--update", "*"});
  EXPECT_EQ(pairs.exitCode, 4);
  EXPECT_THAT(pairs.err, HasSubstr("ref/sub: is a symbolic link; references must be in real folders below ref"));
  EXPECT_FALSE(fs::exists(elsewhere / "new.png"));
}

// The folder of references itself may be a link, because the user made it.
TEST_F(GoldenPaths, AllowALinkToTheFolderOfReferences) {
  save("new/a.png", flat(90));
  fs::create_directory(folder_ / "kept");
  fs::create_directory_symlink("kept", folder_ / "ref");
  manifest("[[test]]\nimage = 'new/*.png'\nname = 'sub/*'\n");
  approve();
  EXPECT_TRUE(fs::exists(folder_ / "kept/sub/a.png"));
  EXPECT_EQ(golden().out, "1 identical\n");
}

TEST_F(GoldenPaths, RejectImagesThatAreTheirOwnReference) {
  save("ref/a.png", flat(90));
  manifest("[[test]]\nimage = 'ref/*.png'\n");
  const RunResult refused = golden();
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_THAT(refused.out, StartsWith("error      a: ref/a.png: is its own reference and would always pass; "));
  EXPECT_EQ(golden({"--update"}).exitCode, 2);
  EXPECT_FALSE(fs::exists(folder_ / "ref/a.json"));
}

// Drawing the tests ref/x and x would overwrite the approved picture of x. Folders may contain each other; only an
// output with the path of a reference is refused.
TEST_F(GoldenPaths, RejectOutputsThatWouldReplaceReferences) {
  folder_.put("s.toml", kGoodScene);
  folder_.put("golden.toml",
              "references = 'o/ref'\nsize = [64, 36]\n[[test]]\nname = 'x'\nscene = 's.toml'\n"
              "[[test]]\nname = 'ref/x'\nscene = 's.toml'\n");
  approve();
  const std::string approved = bytesOf(folder_ / "o/ref/x.png");
  const auto refusalOf = [&](const char* output) {
    const RunResult refused = golden({"-o", output});
    EXPECT_EQ(refused.exitCode, 2) << output;
    return refused.err;
  };
  EXPECT_THAT(refusalOf("o/ref"), HasSubstr("-o o/ref: contains the approved references; choose another folder"));
  EXPECT_THAT(refusalOf("o"),
              HasSubstr("-o o: o/ref/x.png would be the new picture of test 'ref/x' (line 6) and is "
                        "the reference of test 'x' (line 3); choose another folder"));
  EXPECT_EQ(bytesOf(folder_ / "o/ref/x.png"), approved);
  for (const char* output : {".", "o/new", "o/ref/out"}) EXPECT_EQ(golden({"-o", output}).exitCode, 0) << output;
}

TEST_F(GoldenPaths, RejectTestsThatWriteTheSameFile) {
  folder_.put("s.toml", kGoodScene);
  const auto errorOf = [&](const std::string& first, const std::string& second) {
    manifest("[[test]]\nscene = 's.toml'\n" + first + (second.empty() ? "" : "[[test]]\nscene = 's.toml'\n") +
             second);
    const RunResult listed = golden({"--list"});
    const std::vector<std::vector<std::string>> alike{{}, {"--update"}, {"--unused"}, {"--list", "--only", "a"}};
    for (const auto& words : alike) EXPECT_EQ(golden(words).err, listed.err);
    EXPECT_EQ(listed.exitCode, 2) << listed.out;
    EXPECT_FALSE(fs::exists(folder_ / "ref") || fs::exists(folder_ / "out"));
    return listed.err;
  };
  EXPECT_THAT(
      errorOf("name = 'a'\ntimes = [0, 1]\n", "name = 'a_t0'\n"),
      StartsWith(
          "golden.toml:6:1: error: test.name: ref/a_t0.png would be the reference of test 'a' (line 2) and the "
          "reference of test 'a_t0' (line 6); choose other names"));
  EXPECT_THAT(
      errorOf("name = 'a'\ntimes = [0, 0]\n", ""),
      StartsWith("golden.toml:2:1: error: test.times: ref/a_t0.png would be the reference of test 'a' (line 2) at "
                 "two times; give each time once"));
  EXPECT_THAT(errorOf("name = 'a'\n", "name = 'a.flip'\n"),
              HasSubstr("test.name: out/golden/a.flip.png would be the FLIP map of test 'a' (line 2) and the new "
                        "picture of test 'a.flip' (line 5); choose"));
  EXPECT_THAT(errorOf("name = 'a.difference'\n", "name = 'a'\n"), HasSubstr("a.difference.png would be"));
  EXPECT_THAT(errorOf("name = 'a//b'\n", "name = 'a/b'\n"),
              HasSubstr("a/b is already the name of the test in line 2"));
}

// Maps have these names only if -o names the folder of the images.
TEST_F(GoldenPaths, DoNotWriteMapsOverImages) {
  for (const char* name : {"new/a.png", "new/a.flip.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/*.png'\n");
  approve();
  EXPECT_EQ(golden().out, "2 identical\n");
  EXPECT_THAT(
      golden({"-o", "new"}).err,
      HasSubstr(
          "-o new: new/a.flip.png would be the FLIP map of test 'a' (line 2: new/a.png) and is the image of test "
          "'a.flip' (line 2: new/a.flip.png); choose another folder"));
  EXPECT_TRUE(fs::exists(folder_ / "new/a.flip.png"));
}

// A file written among the images of a pattern would be a test of the next run.
TEST_F(GoldenPaths, RejectOutputsThatMatchAPattern) {
  folder_.put("s.toml", kGoodScene);
  save("img/b.png", flat(90));
  const std::string scene = "size = [64, 36]\n[[test]]\nname = 'a'\nscene = 's.toml'\n";
  const auto refusalOf = [&](const std::string& pattern, const std::vector<std::string>& words) {
    manifest(scene + "[[test]]\nimage = '" + pattern + "'\n");
    const RunResult refused = golden(words);
    EXPECT_EQ(refused.exitCode, 2) << pattern << refused.out;
    EXPECT_FALSE(fs::exists(folder_ / "ref") || fs::exists(folder_ / "out")) << pattern;
    EXPECT_THAT(namesIn(folder_ / "img"), ElementsAre("b.png")) << pattern;
    return refused.err;
  };
  const auto taken = [](const std::string& file, const std::string& pattern) {
    return HasSubstr(file + " would match test.image '" + pattern +
                     "' (line 6), so the next run would read it; choose another name or folder");
  };
  fs::create_directory_symlink("img", folder_ / "link");
  for (const char* output : {"img", "./img", "link", "img/../img"})
    EXPECT_THAT(refusalOf("img/*.png", {"-o", output}),
                taken("-o " + std::string(output) + "/a.flip.png", "img/*.png"));
  EXPECT_THAT(refusalOf("img/**/*.png", {"-o", "img/deep/er"}),
              taken("-o img/deep/er/a.flip.png", "img/**/*.png"));
  EXPECT_THAT(refusalOf("link/*.png", {"-o", "img"}), taken("-o img/a.flip.png", "link/*.png"));
  EXPECT_THAT(refusalOf("img/a.p*", {"-o", "img"}), taken("-o img/a.png", "img/a.p*"));
  EXPECT_THAT(refusalOf("nothing/*.png", {"-o", "nothing"}), taken("-o nothing/a.flip.png", "nothing/*.png"));
  fs::remove(folder_ / "nothing");
  EXPECT_THAT(refusalOf("ref/**/*.png", {"--update"}), taken("--update ref/a.png", "ref/**/*.png"));
  EXPECT_THAT(refusalOf("img/*", {"--junit", "img/j.png"}), taken("--junit img/j.png", "img/*"));

  manifest(scene + "[[test]]\nimage = 'img/*.png'\n");
  EXPECT_EQ(golden({"-o", "img/deeper", "--junit", "img/j.xml"}).exitCode, 1);
}

TEST_F(GoldenPaths, AreNamedInErrorsIfPatternsClash) {
  folder_.put("s.toml", kGoodScene);
  for (const char* name : {"img/a.png", "new/a.png"}) save(name, flat(90));
  manifest("[[test]]\nname = 'a'\nscene = 's.toml'\n[[test]]\nimage = 'img/*.png'\n");
  EXPECT_THAT(golden().err, HasSubstr("test.name: a of img/a.png is already the name of the test in line 2;"));
  manifest("[[test]]\nimage = 'img/*.png'\n[[test]]\nimage = 'new/*.png'\n");
  EXPECT_THAT(golden().err, HasSubstr("a of new/a.png is already the name of the test in line 2, of img/a.png;"));
  save("img/a.flip.png", flat(90));
  manifest("[[test]]\nimage = 'img/*.png'\n");
  EXPECT_THAT(golden({"-o", "img"}).err, HasSubstr("is the image of test 'a.flip' (line 2: img/a.flip.png);"));
}

TEST_F(GoldenPaths, DoNotWriteNewPicturesOverImagesOrMasks) {
  folder_.put("s.toml", kGoodScene);
  save("out/golden/a.png", flat(90));
  const std::string scene = "[[test]]\nname = 'a'\nscene = 's.toml'\n";
  manifest(scene + "[[test]]\nname = 'b'\nimage = 'out/golden/a.png'\n");
  EXPECT_THAT(golden().err,
              HasSubstr("-o out/golden: out/golden/a.png would be the new picture of test 'a' (line 2) "
                        "and is the image of test 'b' (line 5); choose another folder"));
  EXPECT_EQ(golden({"-o", "o"}).exitCode, 1);
  manifest(scene + "rule = {mask = 'out/golden/a.png', reason = 'x'}\n");
  EXPECT_THAT(golden().err, HasSubstr("and is the mask of test 'a' (line 2)"));
  EXPECT_EQ(bytesOf(folder_ / "out/golden/a.png").size(), flat(90).size());
}

TEST_F(GoldenPaths, DoNotWriteReferencesOverImagesOrMasks) {
  folder_.put("s.toml", kGoodScene);
  save("ref/a.png", flat(90));
  const std::string scene = "[[test]]\nname = 'a'\nscene = 's.toml'\n";
  for (const char* words :
       {"rule = {mask = 'ref/a.png', reason = 'x'}\n", "[[test]]\nname = 'b'\nimage = 'ref/a.png'\n"}) {
    manifest(scene + words);
    const RunResult refused = golden({"--update"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err,
                HasSubstr("and would be the reference of test 'a' (line 2), so approving would replace "
                          "it; put it into another folder"));
    EXPECT_EQ(bytesOf(folder_ / "ref/a.png").size(), flat(90).size());
  }
}

// A place without write permission is an error before anything is drawn or compared.
TEST_F(GoldenPaths, AreCheckedBeforeDrawing) {
  folder_.put("s.toml", kGoodScene);
  const auto suite = [&] {
    save("new/a.png", flat(90));
    manifest("size = [64, 36]\n[[test]]\nscene = 's.toml'\n[[test]]\nimage = 'new/a.png'\n");
  };
  suite();
  const auto refusalOf = [&](const std::vector<std::string>& words) {
    const RunResult refused = poinsot(words);
    EXPECT_EQ(refused.exitCode, 4) << refused.out;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << refused.err;
    return refused.err;
  };
  for (const char* place : {"ref/a.png", "ref/a.json", "ref/s.json"}) {
    fs::create_directories(folder_ / place);
    EXPECT_THAT(refusalOf({"golden", "--update"}), HasSubstr(std::string(place) + ": is a folder"));
    EXPECT_EQ(namesIn(folder_ / "ref").size(), 1U);
    fs::remove_all(folder_ / "ref");
  }
  folder_.put("ref", "a file");
  EXPECT_THAT(refusalOf({"golden", "--update"}), HasSubstr("ref: not a folder"));
  fs::create_symlink("new/a.png", folder_ / "link.png");
  EXPECT_THAT(refusalOf({"diff", "link.png", "s.toml", "--update", "*"}),
              HasSubstr("link.png: is a symbolic link"));
}

TEST_F(GoldenPaths, AreApprovedAllOrNotAtAll) {
  for (const char* name : {"new/a.png", "new/b.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/a.png'\n[[test]]\nimage = 'new/b.png'\n");
  approve();
  const std::string before = bytesOf(folder_ / "ref/a.png");
  save("new/a.png", flat(120));
  folder_.put("new/b.png", "no picture");
  const RunResult refused = golden({"--update"});
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_THAT(refused.out, AllOf(StartsWith("error      b: new/b.png: "),
                                 HasSubstr("nothing was approved: fix the errors, or choose the other tests")));
  EXPECT_EQ(bytesOf(folder_ / "ref/a.png"), before);
  EXPECT_EQ(golden({"--update", "--only", "a"}).exitCode, 0);
  EXPECT_NE(bytesOf(folder_ / "ref/a.png"), before);
}

// `new` occurs twice in the path; only the folder before the last part is fixed.
TEST_F(GoldenPaths, RejectImagesAboveTheFolderOfTheManifest) {
  manifest("[[test]]\nimage = 'new/../../new'\n");
  EXPECT_THAT(golden().err, StartsWith("golden.toml:3:9: error: test.image: \"new/../../new\" is neither below"));
}

TEST_F(GoldenPaths, ReportLinksAmongReferences) {
  save("new/a.png", flat(90));
  manifest("[[test]]\nimage = 'new/*.png'\n");
  approve();
  fs::rename(folder_ / "ref/a.png", folder_ / "mine.png");
  fs::create_symlink("../mine.png", folder_ / "ref/a.png");
  EXPECT_THAT(golden().out, HasSubstr("unused     a: ref/a.png is a link, which cannot be a reference"));
}

}  // namespace
}  // namespace poinsot
