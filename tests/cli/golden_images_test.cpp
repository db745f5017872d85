// SPDX-License-Identifier: Apache-2.0
// Tests `poinsot golden` with pictures and films of other programs: patterns, variants, and rules with ignored
// places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "cli/golden_images_fixture.h"
#include "support/program_run.h"
#include "support/raw_png.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Bytes film(const std::vector<int>& levels) {
  std::vector<Bytes> pictures;
  for (const int level : levels) pictures.emplace_back(16 * 12, static_cast<std::uint8_t>(level));
  return apngBytes({16, 12, 8, 0, {}}, pictures, std::vector<std::uint16_t>(levels.size(), 100));
}

class GoldenImages : public GoldenImagesFixture {};

// Pairs are the same as those of `diff old new`, for names with brackets and for one name in two folders.
TEST_F(GoldenImages, ArePairedByName) {
  for (const char* name : {"new/wave[1].png", "new/wave[2].png", "new/axes/ticks.png", "new/lines/ticks.png",
                           "new/icon@2x.png", "new/B\xc3\xa4r \xce\xb1.png"})
    save(name, flat(90));
  folder_.put("new/notes.txt", "no picture");
  manifest("[[test]]\nimage = 'new/**/*'\n");
  EXPECT_EQ(golden({"--list"}).out, "B\xc3\xa4r \xce\xb1\naxes/ticks\nicon@2x\nlines/ticks\nwave[1]\nwave[2]\n");
  approve();
  EXPECT_TRUE(fs::exists(folder_ / "ref/axes/ticks.png"));
  EXPECT_EQ(golden().out, "6 identical\n");
  save("new/lines/ticks.png", flat(190));
  EXPECT_THAT(golden().out, StartsWith("different  lines/ticks: largest difference 100"));
  EXPECT_TRUE(fs::exists(folder_ / "out/golden/lines/ticks.flip.png"));
  EXPECT_EQ(golden({"--only", "wave[*]"}).out, "2 identical\n");
  EXPECT_EQ(golden({"--only", "*ticks"}).exitCode, 1);
  EXPECT_EQ(golden({"--only", "nothing*"}).exitCode, 2);
  fs::remove(folder_ / "new/wave[2].png");
  const std::string missing =
      "missing    wave[2]: approved, but new/**/* has no such image; run the program that makes it, or, if the "
      "image is gone for good, remove ref/wave[2].png and ref/wave[2].json\n";
  EXPECT_THAT(golden().out, HasSubstr(missing));
  EXPECT_THAT(golden({"--only", "new/**/*"}).out, HasSubstr(missing));
  EXPECT_THAT(golden({"--only", "wave[1]"}).out, Not(HasSubstr("missing")));
  EXPECT_EQ(golden({"--update", "--only", "new/**/*"}).exitCode, 1);
  EXPECT_TRUE(fs::exists(folder_ / "ref/wave[2].png"));
  EXPECT_EQ(run(folder_, {"diff", "ref", "ref"}).out, "identical: 6 identical\n");
}

// If the program that makes the images failed, continuous integration still needs a report.
TEST_F(GoldenImages, ReportAPatternWithoutFilesAsAnError) {
  save("new/a.png", flat(90));
  save("one.png", flat(90));
  manifest("[[test]]\nname = 'axes/*'\nimage = 'new/*.png'\n[[test]]\nimage = 'one.png'\n");
  approve();
  fs::remove_all(folder_ / "new");
  const RunResult none = golden({"--junit", "j.xml"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_THAT(none.out,
              StartsWith("error      new/*.png: new/*.png matches no PNG and no film; run the program "));
  EXPECT_THAT(
      none.out,
      HasSubstr("missing    axes/a: approved, but new/*.png has no such image; run the program that makes it"));
  EXPECT_THAT(bytesOf(folder_ / "j.xml"), HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\""));
  EXPECT_EQ(golden({"--only", "one"}).out, "1 identical\n");
  EXPECT_EQ(golden({"--update"}).exitCode, 1);
  EXPECT_TRUE(fs::exists(folder_ / "ref/axes/a.png"));
}

TEST_F(GoldenImages, AreChosenByTheirPattern) {
  for (const char* name : {"new/a.png", "new/b.png", "other/c.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/*.png'\n[[test]]\nimage = 'other/*.png'\n");
  EXPECT_EQ(golden({"--list", "--only", "new/*.png"}).out, "a\nb\n");
  const auto list = nlohmann::json::parse(golden({"--list", "--json"}).out);
  EXPECT_EQ(list, nlohmann::json::parse(R"({"tests": [{"name": "a", "image": "new/*.png"},
    {"name": "b", "image": "new/*.png"}, {"name": "c", "image": "other/*.png"}]})"));
}

// A golden.toml among the sources cannot contain the path of the build folder.
TEST_F(GoldenImages, AreReadFromTheFolderInOptionImages) {
  const ScratchFolder build;
  saveBytes(build / "plots/a.png", flat(90));
  manifest("[[test]]\nimage = 'plots/*.png'\n");
  const std::vector<std::string> images{"--images", build.path().string()};
  approve(images);
  EXPECT_EQ(golden(images).out, "1 identical\n");
  saveBytes(build / "plots/a.png", flat(190));
  EXPECT_THAT(golden(images).out, HasSubstr("approve it: poinsot golden golden.toml --images " +
                                            build.path().string() + " --update --only a\n"));
  // --images allows a folder for reading, not for writing.
  folder_.put("golden.toml", "references = '" + build.path().string() + "'\n[[test]]\nimage = 'plots/*.png'\n");
  EXPECT_THAT(golden(images).err, HasSubstr("is not below the folder of this file"));
}

TEST_F(GoldenImages, OptionUnusedFindsReferencesWithoutComparing) {
  for (const char* name : {"new/a.png", "new/deep/b.png", "one.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/**/*.png'\n[[test]]\nimage = 'one.png'\n");
  approve();
  EXPECT_EQ(golden({"--unused"}).out, "no unused references\n");
  save("new/a.png", flat(190));
  fs::remove_all(folder_ / "out/golden");
  EXPECT_EQ(golden({"--unused"}).exitCode, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out/golden"));
  fs::remove_all(folder_ / "new/deep");  // no test makes this folder any more
  for (const RunResult& result : {golden({"--unused"}), golden()}) {
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.out, HasSubstr("missing    deep/b: approved, but new/**/*.png has no such image; run the "
                                      "program that makes it, or, if the image is gone for good, "
                                      "remove ref/deep/b.png"));
  }
  EXPECT_THAT(golden({"--unused", "--only", "a"}).err, HasSubstr("leave out --only and --update"));
}

// A page opened as a file may load scripts and no data, so the outcome is a function call.
TEST_F(GoldenImages, WriteAnOutcomeScriptForTheIndexPage) {
  const auto outcome = [&] {
    const std::string text = bytesOf(folder_ / "o.js");
    EXPECT_THAT(text, StartsWith("poinsotOutcome({"));
    EXPECT_EQ(text.substr(text.size() - 3), ");\n");
    return nlohmann::json::parse(text.substr(15, text.size() - 18));
  };
  for (const char* name : {"new/a.png", "new/b.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/*.png'\n");
  approve();
  fs::create_directory(folder_ / "page");
  EXPECT_EQ(golden({"--outcome", "o.js", "--report", "page/r.html"}).exitCode, 0);
  EXPECT_EQ(outcome()["verdict"], "identical");
  EXPECT_EQ(outcome()["passed"], true);
  EXPECT_EQ(outcome()["counts"], "2 identical");
  EXPECT_EQ(outcome()["page"], "page/r.html");
  save("new/b.png", flat(190));
  EXPECT_EQ(golden({"--outcome", "o.js"}).exitCode, 1);
  EXPECT_EQ(outcome()["verdict"], "different");
  EXPECT_EQ(outcome()["passed"], false);
  EXPECT_THAT(outcome()["message"].get<std::string>(), StartsWith("b: largest difference 100"));
  EXPECT_TRUE(outcome()["page"].is_null());
  // A run that ends before it compares leaves no outcome of an earlier run.
  manifest("[[test]]\nimag = 'new/*.png'\n");
  EXPECT_EQ(golden({"--outcome", "o.js"}).exitCode, 2);
  EXPECT_EQ(outcome()["verdict"], "error");
  EXPECT_THAT(outcome()["message"].get<std::string>(), HasSubstr("golden.toml:3:1"));
  folder_.put("theirs.js", "let a;");
  EXPECT_EQ(golden({"--outcome", "theirs.js"}).exitCode, 4);
  EXPECT_EQ(bytesOf(folder_ / "theirs.js"), "let a;");
}

TEST_F(GoldenImages, ReportOneErrorForOneMistake) {
  manifest("[[test]]\nimage = '../../x.png'\n");
  const RunResult outside = golden();
  EXPECT_THAT(outside.err, StartsWith("golden.toml:3:9: error: test.image: \"../../x.png\" is neither below"));
  EXPECT_THAT(outside.err, Not(HasSubstr("expected either scene or image")));
}

TEST_F(GoldenImages, MayBeFilms) {
  save("new/spin.apng", film({10, 20, 30}));
  save("new/other.png", film({10, 20, 30}));
  manifest("[[test]]\nimage = 'new/*'\n");
  approve();
  EXPECT_EQ(golden().out, "2 identical\n");
  save("new/spin.apng", film({10, 20, 200}));
  save("new/other.png", film({10, 120, 30}));
  const RunResult changed = golden();
  EXPECT_EQ(changed.exitCode, 1);
  EXPECT_THAT(changed.out, HasSubstr("different  spin: frame 2 at 0.200 s: largest difference 170"));
  EXPECT_THAT(changed.out, HasSubstr("different  other: frame 1 at 0.100 s: largest difference 100"));
  EXPECT_TRUE(fs::exists(folder_ / "out/golden/spin.flip.png"));
  approve();
  EXPECT_EQ(golden().exitCode, 0);
}

TEST_F(GoldenImages, AreNotComparedWithUnapprovedPictures) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  save("ref/s@x.png", flat(190));
  save("new.png", flat(190));
  const RunResult result = golden();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, StartsWith("different  s: "));
  EXPECT_THAT(result.out, HasSubstr("unused     s@x: lies beside s.png but was not approved"));
  EXPECT_THAT(golden({"--only", "s"}).out, HasSubstr("unused     s@x"));
  save("new.png", flat(90));
  EXPECT_EQ(golden().exitCode, 1);  // as long as the added picture exists
  folder_.put("ref/s@x.json", bytesOf(folder_ / "ref/s.json"));
  EXPECT_EQ(golden().exitCode, 1);  // variant x was not approved either
}

TEST_F(GoldenImages, HaveAReferenceForEachVariant) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  save("new.png", flat(120));
  EXPECT_EQ(golden().exitCode, 1);
  approve({"--beside", "--variant", "softpipe"});
  EXPECT_TRUE(fs::exists(folder_ / "ref/s@softpipe.png"));
  EXPECT_EQ(golden({"--variant", "softpipe"}).out, "1 identical\n");
  EXPECT_EQ(golden().exitCode, 1);  // the reference of the other driver does not count
  save("new.png", flat(90));
  EXPECT_EQ(golden().out, "1 identical\n");
  EXPECT_EQ(golden({"--variant", "softpipe"}).exitCode, 1);

  const RunResult slip = golden({"--variant", "sofpipe"});
  EXPECT_EQ(slip.exitCode, 2);
  EXPECT_THAT(slip.err, HasSubstr("variant 'sofpipe': has no approved reference; known variants: softpipe"));

  save("new.png", flat(60));
  EXPECT_THAT(golden({"--update"}).out, StartsWith("ref/s@softpipe.png: removed"));
  EXPECT_FALSE(fs::exists(folder_ / "ref/s@softpipe.json"));
  EXPECT_EQ(golden().out, "1 identical\n");
}

TEST_F(GoldenImages, AllowVariantsWithTheSamePicture) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve({"--beside", "--variant", "one"});
  EXPECT_EQ(golden({"--variant", "two"}).exitCode, 2);
  const RunResult made = golden({"--variant", "two", "--update", "--beside"});
  EXPECT_EQ(made.exitCode, 0);
  EXPECT_THAT(made.out, StartsWith("ref/s@two.png: approved, "));
  EXPECT_EQ(golden({"--variant", "two"}).out, "1 identical\n");
  EXPECT_EQ(golden({"--variant", "one"}).out, "1 identical\n");
  EXPECT_EQ(golden({"--variant", "two", "--update", "--beside"}).out, "nothing to approve: 1 identical\n");
}

// A shell or a pattern would give these names another meaning.
TEST_F(GoldenImages, PrintCommandsThatApproveOnlyTheNamedTests) {
  for (const char* name : {"new/-dash.png", "new/a*b.png", "new/a'b.png"}) save(name, flat(90));
  manifest("[[test]]\nimage = 'new/*.png'\n");
  approve();
  for (const char* name : {"new/-dash.png", "new/a*b.png", "new/a'b.png"}) save(name, flat(190));
  const auto approved = [&](const std::string& only) {
    const RunResult failed = golden({"--only", only});
    const std::string mark = "approve it: poinsot ";
    const auto at = failed.out.find(mark);
    EXPECT_NE(at, std::string::npos) << failed.out;
    const std::string command = failed.out.substr(at + mark.size(), failed.out.find('\n', at) - at - mark.size());
    return runShell(folder_.path(), "CI= " POINSOT_PROGRAM " " + command).out;
  };
  EXPECT_THAT(approved("./-dash"), StartsWith("ref/-dash.png: approved"));
  EXPECT_EQ(approved("a\\*b").find("a'b"), std::string::npos);
  EXPECT_EQ(golden().exitCode, 1);
  EXPECT_THAT(approved("a'b"), StartsWith("ref/a'b.png: approved"));
  EXPECT_EQ(golden().exitCode, 0);
}

TEST_F(GoldenImages, RejectSizesInTheManifest) {
  save("new.png", flat(90));
  manifest("[[test]]\nimage = 'new.png'\nsize = [64, 64]\n");
  EXPECT_THAT(
      golden().err,
      HasSubstr("test: the keys `size` and `height` are allowed only beside `scene`; an image has its own size"));
  manifest("[[test]]\nimage = 'new.png'\n");
  const RunResult nowhere = golden({"--images", "nodir"});
  EXPECT_EQ(nowhere.exitCode, 4);
  EXPECT_THAT(nowhere.err, HasSubstr("--images nodir: no such folder"));
}

TEST_F(GoldenImages, TakeTheirVariantFromTheManifest) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  save("new.png", flat(120));
  manifest("variant = 'mesa'\n[[test]]\nname = 's'\nimage = 'new.png'\n");
  EXPECT_THAT(golden().err, HasSubstr("variant 'mesa': has no approved reference; no reference has a variant"));
  approve({"--beside"});
  EXPECT_TRUE(fs::exists(folder_ / "ref/s@mesa.png"));
  EXPECT_EQ(golden().exitCode, 0);
  folder_.put("s.toml", kGoodScene);
  manifest("[[test]]\nscene = 's.toml'\nvariant = 'mesa'\n");
  EXPECT_THAT(golden().err, HasSubstr("variant is allowed with image only"));
}

TEST_F(GoldenImages, IgnoreTheRegionsOfARule) {
  Bytes pixels(16 * 12, 90);
  save("new.png", pngBytes({16, 12, 8, 0, {}}, pixels));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  for (std::size_t i = 0; i < 16; ++i) pixels[i] = 200;  // the top row
  save("new.png", pngBytes({16, 12, 8, 0, {}}, pixels));
  EXPECT_EQ(golden().exitCode, 1);
  const auto with = [&](const std::string& rule) {
    manifest("[[test]]\nname = 's'\nimage = 'new.png'\n" + rule);
    return golden();
  };
  EXPECT_EQ(with("[test.rule]\nignore = [[0, 0, 16, 1]]\nreason = 'a date'\n").out, "1 identical\n");
  EXPECT_EQ(with("[test.rule]\nignore = [0, 0, 16, 1]\nreason = 'a date'\n").exitCode, 0);
  Bytes mask(16 * 12, 0);
  for (std::size_t i = 0; i < 16; ++i) mask[i] = 255;
  save("mask.png", pngBytes({16, 12, 8, 0, {}}, mask));
  EXPECT_EQ(with("[test.rule]\nmask = 'mask.png'\nreason = 'a date'\n").exitCode, 0);
  EXPECT_THAT(with("[test.rule]\nignore = [[0, 0, 16, 12]]\nreason = 'x'\n").out,
              HasSubstr("error      s: the ignored places cover the whole picture"));
  EXPECT_THAT(with("[test.rule]\nignore = [[20, 0, 4, 4]]\nreason = 'x'\n").out,
              HasSubstr("error      s: ignore [20, 0, 4, 4]: outside of the picture, whose size is 16x12"));
  EXPECT_THAT(with("[test.rule]\nignore = [[0, 0, 4]]\nreason = 'x'\n").err,
              HasSubstr("test.rule.ignore: an array of 3: write x, y, width and height in pixels"));
  EXPECT_THAT(with("[test.rule]\nmask = '/etc/x.png'\nreason = 'x'\n").err, HasSubstr("is neither below"));
}

TEST_F(GoldenImages, FollowNamedRulesAndLevels) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  Bytes pixels(16 * 12, 90);
  for (std::size_t i = 0; i < 16 * 3; ++i) pixels[i] = 91;  // a quarter of the pixels, by one level
  save("new.png", pngBytes({16, 12, 8, 0, {}}, pixels));
  const auto with = [&](const std::string& rule) {
    manifest("[[test]]\nname = 's'\nimage = 'new.png'\n" + rule);
    return golden();
  };
  EXPECT_EQ(with("").exitCode, 1);
  EXPECT_EQ(with("rule = 'other_driver'\n").out, "near       s\n1 near\n");
  EXPECT_EQ(with("rule = 'same'\n").exitCode, 1);
  EXPECT_EQ(with("[test.rule]\nlevel = 1\nflip_mean = '0-0.1'\nflip_max = '0-0.1'\nreason = 'x'\n").exitCode, 0);
  EXPECT_EQ(with("[test.rule]\nlike = 'other_driver'\nmax = '0-0.5'\nreason = 'x'\n").exitCode, 1);
  EXPECT_EQ(with("[test.rule]\nmax = '0-0.5'\nlike = 'other_driver'\nreason = 'x'\n").exitCode, 1);
  EXPECT_THAT(with("rule = 'nere'\n").err, HasSubstr("known rules: same, near, other_driver"));
  EXPECT_THAT(
      with("[test.rule]\nmax = '0-255'\npixels = '0-100%'\nflip_mean = '0-1'\nflip_max = '0-1'\nreason = 'x'\n")
          .err,
      HasSubstr("test.rule: the limits: every picture would pass"));
}

// a.json now describes a.png, so the advice must not remove a.json.
TEST_F(GoldenImages, DoNotReportASharedDescriptionAsUnused) {
  save("new/a.png", flat(90));
  save("new/a.apng", film({10, 20}));
  const auto suite = [&](const char* image) { manifest("[[test]]\nimage = '" + std::string(image) + "'\n"); };
  suite("new/a.apng");
  approve();
  suite("new/a.png");
  EXPECT_THAT(golden().out, HasSubstr("unused     a: approved, but no test makes it; remove ref/a.apng\n"));
  EXPECT_THAT(golden({"--update"}).out, HasSubstr("remove ref/a.apng\n"));
  folder_.put("ref/b.png", bytesOf(folder_ / "ref/a.png"));
  folder_.put("ref/b.json", bytesOf(folder_ / "ref/a.json"));
  EXPECT_THAT(golden().out, HasSubstr("remove ref/b.png and ref/b.json\n"));
}

TEST_F(GoldenImages, ReportDescriptionsWithoutAPicture) {
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  approve();
  folder_.put("ref/gone.json", bytesOf(folder_ / "ref/s.json"));
  folder_.put("ref/theirs.json", "{\"a\": 1}");
  const RunResult result = golden();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
            "unused     gone: describes a picture that does not exist; remove ref/gone.json");
  EXPECT_THAT(result.out, Not(HasSubstr("theirs")));
}

TEST_F(GoldenImages, ReportAnUnwritableFolderOnce) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  save("new.png", flat(90));
  manifest("[[test]]\nname = 's'\nimage = 'new.png'\n");
  fs::create_directories(folder_ / "out/golden");
  fs::permissions(folder_ / "out/golden", fs::perms(0555));
  fs::permissions(folder_.path(), fs::perms(0777));
  const ShellResult refused = runShell(
      folder_.path(), "setpriv --reuid=65534 --regid=65534 --clear-groups " POINSOT_PROGRAM " golden 2>&1");
  if (refused.exitCode == 126) GTEST_SKIP() << "nobody may run the program where it was built: " << refused.out;
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.out, HasSubstr("out/golden: cannot be written to: Permission denied"));
  fs::permissions(folder_ / "out/golden", fs::perms(0755));
}

}  // namespace
}  // namespace poinsot
