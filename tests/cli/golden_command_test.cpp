// SPDX-License-Identifier: Apache-2.0
// Tests `poinsot golden` through the life of a suite: new, approved, passed, changed, approved again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image/png_file.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class GoldenCommand : public ::testing::Test {
 protected:
  GoldenCommand() {
    folder_.put("golden.toml", "size = [64, 48]\n[[test]]\nscene = 's.toml'\n");
    folder_.put("s.toml", kGoodScene);
  }

  RunResult golden(std::vector<std::string> words = {}, const std::vector<std::string>& environment = {"CI="}) {
    words.insert(words.begin(), "golden");
    return run(folder_, words, Stdout::kFile, environment);
  }
  void approve() {
    const RunResult made = golden({"--update"});
    ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
  }
  void saveFlat(const std::string& name, int value) {
    image::Image picture({16, 12}, 3);
    picture.pixels.assign(picture.pixels.size(), static_cast<std::uint8_t>(value));
    const auto bytes = image::encodePng(picture);
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  ScratchFolder folder_;
};

// A scene that cannot be drawn is an error, and --quiet leaves out results only.
TEST_F(GoldenCommand, PrintsErrorsOfTestsDespiteOptionQuiet) {
  approve();
  EXPECT_EQ(golden({"--quiet"}).err, "");
  folder_.put("s.toml", "[body]\n");
  const RunResult quiet = golden({"--quiet"});
  EXPECT_EQ(quiet.exitCode, 1);
  EXPECT_EQ(quiet.out, "");
  EXPECT_THAT(quiet.err, StartsWith("error      s: "));
  EXPECT_THAT(quiet.err, HasSubstr("s.toml:1:1"));
}

TEST_F(GoldenCommand, ReportsNewApprovedAndChangedPictures) {
  const RunResult first = golden();
  EXPECT_EQ(first.exitCode, 1);
  EXPECT_THAT(first.out, StartsWith("new        s: nothing was approved yet"));
  EXPECT_EQ(golden({"--update"}).out, "golden/s.png: approved as the first reference of its test\n");
  EXPECT_EQ(golden().out, "1 identical\n");
  EXPECT_EQ(golden({"--exact"}).exitCode, 0);

  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  const RunResult changed = golden();
  EXPECT_EQ(changed.exitCode, 1);
  EXPECT_THAT(changed.out, StartsWith("different  s: largest difference "));
  for (const char* name : {"s.png", "s.flip.png", "s.difference.png"})
    EXPECT_TRUE(fs::exists(folder_ / "out/golden" / name)) << name;
  EXPECT_THAT(golden({"--update"}).out,
              ::testing::ContainsRegex("s.png: approved, [0-9]+ pixels changed.*FLIP mean 0"));
  EXPECT_EQ(golden().exitCode, 0);
}

TEST_F(GoldenCommand, ApprovesNothingInCi) {
  const RunResult refused = golden({"--update"}, {"CI=true"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err, HasSubstr("not possible while the environment variable CI is set"));
  EXPECT_FALSE(fs::exists(folder_ / "golden"));
}

TEST_F(GoldenCommand, RecordsRendererSoftwareAndSceneOfAReference) {
  approve();
  const auto origin = nlohmann::json::parse(bytesOf(folder_ / "golden/s.json"));
  EXPECT_THAT(origin["renderer"].get<std::string>(), StartsWith("llvmpipe"));
  EXPECT_THAT(origin["software"].get<std::string>(), StartsWith("poinsot "));
  EXPECT_EQ(origin["scene"].get<std::string>().size(), 64u);
}

// A JSON file of another program does not describe the picture beside it.
TEST_F(GoldenCommand, IgnoresAForeignJsonNextToAReference) {
  approve();
  folder_.put("golden/s.json", "[1]");
  EXPECT_EQ(golden().out, "1 identical\n");
  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  EXPECT_EQ(golden().exitCode, 1);
}

// The file may hold the parameters of the user's own program.
TEST_F(GoldenCommand, ReplacesAForeignJsonOnlyWithForce) {
  fs::create_directory(folder_ / "golden");
  folder_.put("golden/s.json", "{\"renderer\": \"mine\", \"gain\": 3}");
  const RunResult refused = golden({"--update"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_EQ(
      refused.err,
      "poinsot: error: golden/s.json: exists and was not written by poinsot as a description of a reference; "
      "--force replaces it\n");
  EXPECT_EQ(bytesOf(folder_ / "golden/s.json"), "{\"renderer\": \"mine\", \"gain\": 3}");
  EXPECT_FALSE(fs::exists(folder_ / "golden/s.png"));
  EXPECT_EQ(golden({"--update", "--force"}).exitCode, 0);
  EXPECT_THAT(bytesOf(folder_ / "golden/s.json"), HasSubstr("llvmpipe"));
}

// If there is a reference by the same renderer, only that reference counts. Otherwise any approved reference
// counts.
TEST_F(GoldenCommand, PrefersTheReferenceOfTheSameRenderer) {
  approve();
  const auto ours = nlohmann::json::parse(bytesOf(folder_ / "golden/s.json"));
  auto theirs = ours;
  theirs["renderer"] = "softpipe";
  folder_.put("golden/s.json", theirs.dump());
  EXPECT_EQ(golden().exitCode, 0);  // reference of another renderer, same pixels

  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  EXPECT_EQ(golden().exitCode, 1);
  const RunResult beside = golden({"--update", "--beside"});
  EXPECT_THAT(beside.out, StartsWith("golden/s@llvmpipe_LLVM"));
  EXPECT_TRUE(fs::exists(folder_ / "golden/s.png"));
  EXPECT_EQ(golden().out, "1 identical\n");
  folder_.put("s.toml", kGoodScene);
  EXPECT_EQ(golden().exitCode, 1);  // only the other renderer's reference has this look

  folder_.put("golden/s.json", theirs.dump());
  fs::remove(folder_ / "golden/s@llvmpipe_LLVM_15.0.6_128_bits.png");
  for (const auto& entry : fs::directory_iterator(folder_ / "golden"))
    if (entry.path().filename().native().find('@') != std::string::npos) fs::remove(entry.path());
  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  approve();  // replaces all references
  EXPECT_EQ(nlohmann::json::parse(bytesOf(folder_ / "golden/s.json"))["renderer"], ours["renderer"]);
}

// References of other renderers show the old scene.
TEST_F(GoldenCommand, RemovesReferencesOfAnEarlierSceneOnUpdate) {
  approve();
  const std::string old = bytesOf(folder_ / "golden/s.png");
  auto theirs = nlohmann::json::parse(bytesOf(folder_ / "golden/s.json"));
  theirs["renderer"] = "softpipe";
  folder_.put("golden/s@softpipe.png", old);
  folder_.put("golden/s@softpipe.json", theirs.dump());
  EXPECT_EQ(golden().out, "1 identical\n");
  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  EXPECT_THAT(
      golden({"--update"}).out,
      StartsWith("golden/s@softpipe.png: removed: it was approved for an earlier scene or picture\ngolden/s.png: "
                 "approved, "));
  EXPECT_FALSE(fs::exists(folder_ / "golden/s@softpipe.png"));
  EXPECT_FALSE(fs::exists(folder_ / "golden/s@softpipe.json"));
}

TEST_F(GoldenCommand, DoesNotOverwriteReferencesOrForeignFiles) {
  approve();
  const std::string approved = bytesOf(folder_ / "golden/s.png");
  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  const RunResult overApproved = golden({"-o", "golden"});
  EXPECT_EQ(overApproved.exitCode, 2);
  EXPECT_THAT(overApproved.err, HasSubstr("-o golden: contains the approved references; choose another folder"));
  EXPECT_EQ(bytesOf(folder_ / "golden/s.png"), approved);

  folder_.put("theirs.txt", "somebody's");
  for (const char* report : {"--report", "--junit"}) {
    EXPECT_EQ(golden({report, "theirs.txt"}).exitCode, 4);
    EXPECT_EQ(bytesOf(folder_ / "theirs.txt"), "somebody's");
    for (int i = 0; i < 2; ++i) EXPECT_EQ(golden({report, "own.txt"}).exitCode, 1) << "in place of its own";
    fs::remove(folder_ / "own.txt");
  }
  EXPECT_EQ(golden({"--report", "theirs.txt", "--force"}).exitCode, 1);

  fs::create_directory(folder_ / "pictures");
  folder_.put("pictures/s.png", "somebody's");
  const RunResult refused = golden({"-o", "pictures"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err, HasSubstr("s.png: exists and was not written by poinsot; --force replaces it"));
  EXPECT_EQ(bytesOf(folder_ / "pictures/s.png"), "somebody's");
}

TEST_F(GoldenCommand, RejectsOptionBesideForPicturesOfOtherPrograms) {
  saveFlat("theirs.png", 90);
  folder_.put("golden.toml", "[[test]]\nimage = 'theirs.png'\n");
  approve();
  const RunResult refused = golden({"--update", "--beside"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err, HasSubstr("--beside: theirs: another program made this picture"));
  EXPECT_EQ(golden({"--beside"}).exitCode, 2);
}

TEST_F(GoldenCommand, RunsTestsOfTimesPatternsAndForeignPictures) {
  fs::create_directory(folder_ / "scenes");
  folder_.put("scenes/one.toml", kGoodScene);
  folder_.put("scenes/two.toml", kGoodScene);
  saveFlat("theirs.png", 90);
  folder_.put("golden.toml",
              "references = 'ref'\nheight = 36\n[[test]]\nname = 'g_*'\nscene = 'scenes/*.toml'\n"
              "[[test]]\nname = 'twice'\nscene = 's.toml'\ntimes = [0.5, '1 s']\nset = ['style.theme=dark']\n"
              "[[test]]\nimage = 'theirs.png'\n");
  EXPECT_EQ(golden({"--list"}).out, "g_one\ng_two\ntwice_t0.5\ntwice_t1\ntheirs\n");
  approve();
  EXPECT_EQ(golden().out, "5 identical\n");
  EXPECT_EQ(image::readPng(folder_ / "ref/g_one.png").size, (image::PixelSize{64, 36}));
  EXPECT_EQ(golden({"--only", "twice"}).out, "2 identical\n");
  EXPECT_EQ(golden({"--only", "twice_t1", "g_two"}).out, "2 identical\n");
  const RunResult unknown = golden({"--only", "g_tow"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.err, HasSubstr("g_tow: no such test; did you mean 'g_two'?"));
  saveFlat("theirs.png", 95);
  EXPECT_EQ(golden({"--only", "theirs"}).exitCode, 1);
}

TEST_F(GoldenCommand, ComparesTheSheetOfASweep) {
  folder_.put("golden.toml",
              "size = [160, 90]\n[[test]]\nname = 'sheet'\nscene = 's.toml'\ntimes = [0.5]\n"
              "set = ['motion.omega_body=[0.1..0.5:4, 10, 0]']\n");
  approve();
  EXPECT_EQ(golden().out, "1 identical\n");
  const RunResult drawn = run(folder_, {"sweep", "s.toml", "-D", "motion.omega_body=[0.1..0.5:4, 10, 0]", "--time",
                                        "0.5", "--size", "160x90", "-o", "sheet.png"});
  EXPECT_EQ(drawn.exitCode, 0) << drawn.err;
  EXPECT_EQ(image::readPng(folder_ / "golden/sheet.png").pixels, image::readPng(folder_ / "sheet.png").pixels);
}

TEST_F(GoldenCommand, RejectsTimesOutsideTheFilm) {
  folder_.put("golden.toml", "[[test]]\nscene = 's.toml'\nsize = [64, 36]\ntimes = [0.5, 50]\n");
  const RunResult result = golden();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, HasSubstr("error      s_t50: golden.toml:4:9: times: the film lasts from 0 to "));
  EXPECT_THAT(result.out, HasSubstr("new        s_t0.5"));
  const RunResult other = golden({"--only", "zzz"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_THAT(other.err, HasSubstr("zzz: no such test; known tests: s_t0.5, s, s_t50"));
}

TEST_F(GoldenCommand, ReportsUnusedReferencesAndMissingPictures) {
  approve();
  saveFlat("golden/gone.png", 1);
  EXPECT_THAT(golden().out, HasSubstr("unused     gone: approved, but no test makes it; remove golden/gone.png"));
  folder_.put("golden.toml", "[[test]]\nimage = 'nothing.png'\n");
  const RunResult missing = golden();
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_THAT(missing.out, HasSubstr("error      nothing: "));
  folder_.put("golden.toml", "[[test]]\nscene = 's.toml'\ntimes = [0, 0.5]\n");
  folder_.put("s.toml", "[body]\nprincipal_moment = [1, 2, 3]\n");
  const RunResult wrong = golden();
  EXPECT_THAT(wrong.out,
              HasSubstr("error      s_t0: s.toml:2:1: error: body.principal_moment: unknown key; did you "
                        "mean body.principal_moments?"));
  EXPECT_THAT(wrong.out, HasSubstr("\n"
                                   "error      s_t0.5: same error as above\n"));
  EXPECT_THAT(wrong.out,
              HasSubstr("unused     gone: approved, but no test makes it; first fix the tests with errors\n"));
}

TEST_F(GoldenCommand, AppliesTheRuleOfATestAndPrintsItsReason) {
  saveFlat("theirs.png", 90);
  folder_.put("golden.toml", "[[test]]\nimage = 'theirs.png'\n");
  approve();
  saveFlat("theirs.png", 93);
  EXPECT_EQ(golden().exitCode, 1);
  folder_.put("golden.toml",
              "[[test]]\nimage = 'theirs.png'\n[test.rule]\nmax = '0-3'\npixels = '0-100%'\nflip_mean = '0-1'\n"
              "flip_max = '0-1'\nreason = 'another exposure'\n");
  const RunResult near = golden();
  EXPECT_EQ(near.exitCode, 0);
  EXPECT_EQ(near.out, "near       theirs: another exposure\n1 near\n");
  EXPECT_EQ(golden({"--exact"}).exitCode, 1);
}

TEST_F(GoldenCommand, ReportsLineOfMistakesInTheManifest) {
  const auto refusal = [&](const std::string& text) {
    folder_.put("golden.toml", text);
    const RunResult result = golden();
    EXPECT_EQ(result.exitCode, 2) << text;
    return result.err;
  };
  EXPECT_THAT(refusal("[[test]]\nscene = 's.toml'\nrule = { max = '0-9' }\n"),
              HasSubstr("golden.toml:3:8: error: test.rule: expected the key reason beside the limits"));
  EXPECT_THAT(refusal("[[test]]\nscene = 's.toml'\nrule = { max = '3', reason = 'x' }\n"),
              HasSubstr("golden.toml:3:16: error: test.rule.max: a limit '3': write 0-3"));
  EXPECT_EQ(refusal("[[test]]\nscene = 's.toml'\nrule = 3\n"),
            "golden.toml:3:8: error: test.rule: expected a table, got 3\n   3 | rule = 3\n     |        ^\n");
  EXPECT_THAT(refusal("[[test]]\nscen = 's.toml'\n"),
              HasSubstr("test.scen: unknown key; did you mean test.scene?"));
  EXPECT_THAT(refusal("[[test]]\nname = '../x'\nscene = 's.toml'\n"),
              HasSubstr("must be a relative path of at most 200 printable characters"));
  EXPECT_THAT(refusal("[[test]]\nscene = 's.toml'\n[[test]]\nscene = 's.toml'\n"),
              HasSubstr("golden.toml:3:1: error: test.name: s is already the name of the test in line 1"));
  EXPECT_THAT(refusal("[[test]]\nscene = 'no*.toml'\n"), HasSubstr("no file matches no*.toml"));
  EXPECT_THAT(refusal("[[test]]\nsize = [0, 5]\nscene = 's.toml'\n"),
              HasSubstr("expected pixels from 16 to 8192, got 0"));
  EXPECT_THAT(refusal("size = [64, 64]\n"), HasSubstr("expected at least one [[test]]"));
  fs::remove(folder_ / "golden.toml");
  EXPECT_EQ(golden().exitCode, 4);
}

TEST_F(GoldenCommand, RejectsAHeightThatMakesThePictureTooWide) {
  folder_.put("golden.toml", "[[test]]\nscene = 's.toml'\nset = 'output.size=[8192, 16]'\nheight = 17\n");
  const RunResult result = golden();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, HasSubstr("golden.toml:4:10: height: 17 pixels would make this scene of 8192x16 8704 "
                                    "pixels wide; sides must be from 16 to 8192 pixels"));
}

// A golden.toml may come from a stranger, too. Its files must lie below its folder or in a folder that the user
// names.
TEST_F(GoldenCommand, RejectsPathsOutsideItsFolders) {
  const ScratchFolder elsewhere;
  elsewhere.put("secret.toml", "password = 'x'\n");
  fs::create_symlink(elsewhere / "secret.toml", folder_ / "link.toml");
  fs::create_directory_symlink(elsewhere.path(), folder_ / "away");
  const auto refusal = [&](const std::string& text) {
    folder_.put("golden.toml", text);
    const RunResult result = golden({"--update"});
    EXPECT_EQ(result.exitCode, 2) << text;
    EXPECT_THAT(result.err, Not(HasSubstr("password")));
    return result.err;
  };
  const std::string outside = elsewhere.path().string();
  const std::string read =
      "is neither below the folder of this file nor below the current one; --asset-root FOLDER";
  EXPECT_THAT(refusal("[[test]]\nscene = '" + outside + "/secret.toml'\n"),
              HasSubstr("golden.toml:2:9: error: test.scene: \"" + outside + "/secret.toml\" " + read));
  EXPECT_THAT(refusal("[[test]]\nscene = '../*/secret.toml'\n"), HasSubstr(read));
  EXPECT_THAT(refusal("[[test]]\nscene = '../*.toml'\n"), HasSubstr(read));
  EXPECT_THAT(refusal("[[test]]\nscene = 'away/*.toml'\n"), HasSubstr(read));
  EXPECT_THAT(refusal("[[test]]\nscene = 'link.toml'\n"), HasSubstr("is a link to a place outside"));
  EXPECT_THAT(refusal("[[test]]\nscene = 'lin*.toml'\n"), HasSubstr("is a link to a place outside"));
  EXPECT_THAT(refusal("[[test]]\nimage = '/etc/passwd'\n"), HasSubstr("test.image: \"/etc/passwd\" " + read));
  EXPECT_THAT(refusal("[[test]]\nimage = 'away/x.png'\n"), HasSubstr(read));
  for (const char* references : {"..", "/tmp", "away", "golden/../.."})
    EXPECT_THAT(refusal("references = '" + std::string(references) + "'\n[[test]]\nscene = 's.toml'\n"),
                HasSubstr("is not below the folder of this file; --asset-root FOLDER allows another"));
  EXPECT_EQ(namesIn(elsewhere.path()), std::vector<std::string>{"secret.toml"});

  elsewhere.put("s.toml", kGoodScene);
  folder_.put("golden.toml", "references = '" + outside + "/approved'\nsize = [64, 48]\n[[test]]\nscene = '" +
                                 outside + "/s.toml'\n");
  EXPECT_EQ(golden({"--update", "--asset-root", outside}).exitCode, 0);
  EXPECT_TRUE(fs::exists(elsewhere / "approved/s.png"));
  EXPECT_EQ(golden({"--asset-root", outside}).out, "1 identical\n");
}

// A link in the folder of references could lead to any picture of the user, so it is not a reference.
TEST_F(GoldenCommand, IgnoresLinksAmongReferences) {
  approve();
  fs::rename(folder_ / "golden/s.png", folder_ / "mine.png");
  fs::create_symlink("../mine.png", folder_ / "golden/s.png");
  EXPECT_THAT(golden().out, StartsWith("new        s: nothing was approved yet"));
}

TEST_F(GoldenCommand, ReportsPicturesThatExceedTheMemoryLimit) {
  const RunResult refused = golden({"--max-memory", "100MiB"});
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_THAT(refused.out, HasSubstr("error      s: a worker that makes pictures of 64x48: about 0.1 GiB of "
                                     "memory, more than the allowed 100 MiB; --max-memory SIZE raises the limit"));
}

TEST_F(GoldenCommand, WritesJUnitAndHtmlReports) {
  saveFlat("theirs.png", 90);
  folder_.put("golden.toml",
              "size = [64, 48]\n[[test]]\nscene = 's.toml'\n[[test]]\nname = 'theirs'\nimage = 'theirs.png'\n");
  approve();
  saveFlat("theirs.png", 190);
  EXPECT_EQ(golden({"--junit", "j.xml", "--report", "r.html"}).exitCode, 1);
  const std::string xml = bytesOf(folder_ / "j.xml"), page = bytesOf(folder_ / "r.html");
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\" errors=\"0\""));
  EXPECT_THAT(xml, HasSubstr("name=\"theirs\""));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"different\" message=\"largest difference 100 (limit 2)"));
  EXPECT_THAT(page, HasSubstr("\"name\":\"theirs\",\"status\":\"different\""));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
}

}  // namespace
}  // namespace poinsot
