// SPDX-License-Identifier: Apache-2.0
// Tests `poinsot diff` as other programs call it: exit codes, the JSON object, folders, films.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "image/png_file.h"
#include "support/program_run.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

image::Image grey(image::PixelSize size, int value, int channels = 3) {
  image::Image picture(size, channels);
  picture.pixels.assign(picture.pixels.size(), static_cast<std::uint8_t>(value));
  return picture;
}

template <class Picture>
void save(const std::filesystem::path& file, const Picture& picture) {
  std::filesystem::create_directories(file.parent_path());
  const auto bytes = image::encodePng(picture);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

json dataOf(const std::string& page) {
  const std::string mark = "type=\"application/json\">";
  const auto begin = page.find(mark) + mark.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin), nullptr, false);
}

class DiffCommand : public ::testing::Test {
 protected:
  DiffCommand() {
    save(folder_ / "a.png", a_);
    save(folder_ / "same.png", a_);
    image::Image near = a_, far = a_;
    near.at(30, 20)[1] += 1;
    for (int c = 0; c < 3; ++c) far.at(30, 20)[c] = 255;
    save(folder_ / "near.png", near);
    save(folder_ / "far.png", far);
  }

  RunResult diff(std::vector<std::string> words) {
    words.insert(words.begin(), "diff");
    return run(folder_, words);
  }
  json figures(std::vector<std::string> words, int exitCode) {
    words.emplace_back("--json");
    const RunResult result = diff(words);
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    return json::parse(result.out, nullptr, false);
  }

  const image::Image a_ = grey({64, 48}, 100);
  ScratchFolder folder_;
};

TEST_F(DiffCommand, HasThreeVerdictsAndTheirExitCodes) {
  for (const auto& [test, verdict, code, exactCode] :
       {std::tuple("same.png", "identical", 0, 0), {"near.png", "near", 0, 1}, {"far.png", "different", 1, 1}}) {
    const RunResult result = diff({"a.png", test});
    EXPECT_EQ(result.exitCode, code) << result.err;
    EXPECT_THAT(result.out, StartsWith(verdict));
    EXPECT_EQ(diff({"a.png", test, "--exact"}).exitCode, exactCode);
    EXPECT_EQ(diff({"a.png", test, "--quiet"}).out, "");
  }
}

// Computed by hand: 64x48 = 3072 pixels, 9216 values; one pixel went from 100 to 255 in each channel.
TEST_F(DiffCommand, ReportsTheFiguresOfAPair) {
  const json far = figures({"a.png", "far.png"}, 1);
  EXPECT_EQ(far["verdict"], "different");
  EXPECT_EQ(far["differing_pixels"], 1);
  EXPECT_EQ(far["max_difference"], 155);
  EXPECT_NEAR(far["mean_difference"].get<double>(), 3 * 155.0 / 9216, 1e-12);
  EXPECT_NEAR(far["rmse"].get<double>(), std::sqrt(3 * 155.0 * 155 / 9216), 1e-12);
  EXPECT_NEAR(far["psnr_db"].get<double>(), 10 * std::log10(255.0 * 255 * 9216 / (3 * 155.0 * 155)), 1e-9);
  EXPECT_EQ(far["worst_pixels"][0]["x"], 30);
  EXPECT_EQ(far["worst_pixels"][0]["y"], 20);
  EXPECT_EQ(far["worst_pixels"][0]["test"], json({255, 255, 255}));
  EXPECT_LT(far["ssim"]["worst"].get<double>(), far["ssim"]["mean"].get<double>());
  EXPECT_GT(far["flip"]["max"].get<double>(), 0.4);
  EXPECT_THAT(far["beyond"].dump(), HasSubstr("largest difference 155 (limit 2)"));

  const json same = figures({"a.png", "same.png"}, 0);
  EXPECT_EQ(same["verdict"], "identical");
  EXPECT_EQ(same["psnr_db"], nullptr);
  EXPECT_EQ(same["ssim"]["mean"], 1.0);
  EXPECT_EQ(same["flip"]["mean"], 0.0);
}

TEST_F(DiffCommand, ReportsAnotherSizeAsDifferentWithoutResizing) {
  save(folder_ / "wide.png", grey({65, 48}, 100));
  const RunResult wide = diff({"a.png", "wide.png"});
  EXPECT_EQ(wide.exitCode, 1);
  EXPECT_EQ(wide.out, "different: the size is 65x48, not 64x48\n");
  const json figureless = figures({"a.png", "wide.png"}, 1);
  EXPECT_EQ(figureless["verdict"], "different");
  EXPECT_EQ(figureless["flip"], nullptr);
  EXPECT_EQ(figureless["differing_pixels"], nullptr);
}

TEST_F(DiffCommand, ComparesPicturesOfOnePixelAndOfSixteenBits) {
  save(folder_ / "one.png", grey({1, 1}, 5));
  save(folder_ / "two.png", grey({1, 1}, 6));
  const json one = figures({"one.png", "two.png"}, 1);
  EXPECT_EQ(one["differing_share"], 1.0);
  EXPECT_EQ(one["ssim"], nullptr);
  image::DeepImage deep({64, 48}, 3);
  deep.pixels.assign(deep.pixels.size(), 257 * 100);
  save(folder_ / "deep.png", deep);
  EXPECT_EQ(figures({"a.png", "deep.png"}, 0)["verdict"], "identical");
  deep.pixels[0] += 1;
  save(folder_ / "deeper.png", deep);
  EXPECT_NEAR(figures({"deep.png", "deeper.png"}, 0)["max_difference"].get<double>(), 255.0 / 65535, 1e-12);
}

TEST_F(DiffCommand, TakesLimitsAsRangesFromZero) {
  EXPECT_EQ(diff({"a.png", "far.png", "--max", "0-255", "--flip-mean", "0-1", "--flip-max", "0-1"}).exitCode, 0);
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-0"}).exitCode, 1);
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-0.01%"}).exitCode, 1);  // 0.01 % is 0.3 of a pixel
  const RunResult bare = diff({"a.png", "near.png", "--max", "3"});
  EXPECT_EQ(bare.exitCode, 2);
  EXPECT_THAT(bare.err, HasSubstr("--max '3': write 0-3: a limit is a range from 0"));
  for (const char* word : {"0-256", "1-3", "0--1", "x", "0-nan"})
    EXPECT_EQ(diff({"a.png", "near.png", "--max", word}).exitCode, 2) << word;
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-1.5"}).exitCode, 2);
}

TEST_F(DiffCommand, WritesMapAndDifferencePictures) {
  EXPECT_EQ(diff({"a.png", "far.png", "--map", "map.png", "--diff-image", "d.png"}).exitCode, 1);
  const image::Image map = image::readPng(folder_ / "map.png"), d = image::readPng(folder_ / "d.png");
  EXPECT_EQ(map.size, a_.size);
  EXPECT_GT(map.at(30, 20)[0], 150);
  EXPECT_EQ(map.at(60, 40)[2], 4);  // magma's colour for 0 is #000004
  EXPECT_EQ(d.at(30, 20)[0], 255);
  EXPECT_EQ(d.at(31, 20)[0], 0);
}

TEST_F(DiffCommand, ReportsUnreadableAndUnsuitableFiles) {
  EXPECT_EQ(diff({"a.png", "none.png"}).exitCode, 4);
  folder_.put("text.png", "no picture");
  const RunResult text = diff({"a.png", "text.png"});
  EXPECT_EQ(text.exitCode, 4);
  EXPECT_THAT(text.err, HasSubstr("text.png: not a readable PNG"));
  EXPECT_EQ(diff({"a.png", "."}).exitCode, 2);
  EXPECT_EQ(diff({"a.png", "far.png", "--curve", "c.csv"}).exitCode, 2);
}

TEST_F(DiffCommand, PairsFoldersByName) {
  for (const char* name : {"old/one.png", "new/one.png", "old/in/two.png", "old/gone.png", "new/more.png"})
    save(folder_ / name, a_);
  image::Image changed = a_;
  changed.at(3, 4)[2] = 0;
  save(folder_ / "new/in/two.png", changed);
  const RunResult result = diff({"old", "new", "--map", "maps"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(
      result.out,
      StartsWith("different: 1 identical, 1 different, 1 missing, 1 new\n  different  in/two.png: largest"));
  EXPECT_THAT(result.out, HasSubstr("  missing    gone.png\n  new        more.png\n"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "maps/in/two.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps/one.png"));
  const json both = figures({"old", "new"}, 1);
  EXPECT_EQ(both["pictures"].size(), 2u);
  EXPECT_EQ(both["pictures"][0]["name"], "in/two.png");
  EXPECT_EQ(both["only_in_reference"], json::array({"gone.png"}));
  EXPECT_EQ(figures({"old", "old"}, 0)["verdict"], "identical");
  EXPECT_EQ(diff({"old", "maps/none"}).exitCode, 4);  // a folder and a missing path
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_THAT(diff({"empty", "new"}).out, StartsWith("different: 3 new\n"));  // first run, nothing is approved yet
  EXPECT_EQ(diff({"new", "empty"}).exitCode, 1);
  const RunResult none = diff({"empty", "empty"});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_EQ(none.err, "poinsot: error: empty and empty: neither folder contains a PNG file or a film\n");
}

TEST_F(DiffCommand, ComparesFilmsFrameByFrame) {
  folder_.put("s.toml", kGoodScene);
  const auto film = [&](const std::string& name, const std::string& frames, const std::string& more) {
    EXPECT_EQ(run(folder_, {"render", "s.toml", "-o", name, "--frames", frames, "-D", more, "--quiet"}).exitCode,
              0);
  };
  film("a.mp4", "0-7", "output.crf=10");
  film("b.mp4", "0-7", "output.crf=30");
  film("short.mp4", "0-5", "output.crf=10");
  EXPECT_EQ(figures({"a.mp4", "a.mp4"}, 0)["verdict"], "identical");
  const json coarse = figures({"a.mp4", "b.mp4", "--curve", "c.csv", "--map", "m.png"}, 1);
  EXPECT_EQ(coarse["frames"].size(), 8u);
  EXPECT_EQ(coarse["fps"], "30/1");
  EXPECT_EQ(image::readPng(folder_ / "m.png").size, (image::PixelSize{160, 90}));
  const std::string curve = bytesOf(folder_ / "c.csv");
  EXPECT_THAT(curve, StartsWith("frame,t,verdict,"));
  EXPECT_EQ(std::ranges::count(curve, '\n'), 9);
  EXPECT_THAT(diff({"a.mp4", "short.mp4"}).out, StartsWith("different: the film has 6 frames, not 8\n"));
}

TEST_F(DiffCommand, ReportsSizesAndFrameRatesThatDiffer) {
  folder_.put("s.toml", kGoodScene);
  const auto film = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"render", "s.toml", "--frames", "0-3", "--quiet", "-o"});
    EXPECT_EQ(run(folder_, words).exitCode, 0);
  };
  film({"a.mp4"});
  film({"large.mp4", "--size", "192x108"});
  film({"slow.mp4", "--fps", "25"});
  for (const char* what : {"--curve=c.csv", "--curve=c.svg", "--report=r.html"}) {
    const RunResult size = diff({"a.mp4", "large.mp4", what}), rate = diff({"a.mp4", "slow.mp4", what});
    EXPECT_EQ(size.exitCode, 1);
    EXPECT_EQ(size.out, "different: the size is 192x108, not 160x90\n");
    EXPECT_EQ(rate.exitCode, 1);
    EXPECT_THAT(rate.out, StartsWith("different: the film has 25 frames a second, not 30\n"));
  }
  EXPECT_EQ(diff({"a.mp4", "large.mp4", "--curve", "size.svg"}).exitCode, 1);
  EXPECT_THAT(bytesOf(folder_ / "size.svg"), HasSubstr(">the size is 192x108, not 160x90</text>"));
}

// Films of any two formats can be compared. GIF may have another frame rate than it was rendered at, and alpha.
TEST_F(DiffCommand, ComparesFilmsOfAnyTwoFormats) {
  folder_.put("s.toml", kGoodScene);
  for (const char* name : {"a.mp4", "a.gif", "a.apng", "a.webm"})
    EXPECT_EQ(run(folder_, {"render", "s.toml", "--frames", "0-3", "--quiet", "-o", name}).exitCode, 0);
  for (const char* name : {"a.gif", "a.apng", "a.webm"}) {
    const json made = json::parse(diff({"a.mp4", name, "--json"}).out, nullptr, false);
    EXPECT_EQ(made["mismatch"], nullptr) << name;
    ASSERT_EQ(made["frames"].size(), 4u) << name;
    EXPECT_EQ(made["frames"][1]["mismatch"], nullptr) << name;
    EXPECT_LT(made["frames"][1]["flip"]["mean"], 0.1) << name;
  }
}

TEST_F(DiffCommand, DoesNotOverwriteThePicturesItCompares) {
  const std::string reference = bytesOf(folder_ / "a.png");
  for (const char* what : {"--map", "--diff-image", "--report"}) {
    const RunResult refused = diff({"a.png", "far.png", what, "./a.png", "--force"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("./a.png is the same file as"));
  }
  EXPECT_EQ(bytesOf(folder_ / "a.png"), reference);
}

TEST_F(DiffCommand, ReportsAllPairsIfOneCannotBeRead) {
  for (const char* name : {"old/a.png", "new/a.png", "old/c.png"}) save(folder_ / name, a_);
  save(folder_ / "new/c.png", grey({64, 48}, 200));
  save(folder_ / "old/b.png", a_);
  folder_.put("new/b.png", "no picture");
  const RunResult result = diff({"old", "new", "--report", "r.html"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_THAT(result.out, StartsWith("different: 1 identical, 1 different, 1 error\n"));
  EXPECT_THAT(result.out, HasSubstr("  different  c.png: largest 100"));
  EXPECT_THAT(result.err, HasSubstr("new/b.png: not a readable PNG"));
  const json entries = dataOf(bytesOf(folder_ / "r.html"))["entries"];
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[1]["status"], "error");
  EXPECT_THAT(entries[1]["reference"].dump(), StartsWith("\"data:image/png;base64,"))
      << "the one that can be read";
  EXPECT_EQ(entries[1]["actual"], nullptr);
}

// far.png has one white pixel at (30, 20) on grey 100, which is 0x64. Each channel of c.png is 100 higher.
TEST_F(DiffCommand, DescribesTheChangeInWords) {
  const std::string words = "1 pixel at (30, 20), #646464 became #ffffff";
  EXPECT_THAT(diff({"a.png", "far.png"}).out, HasSubstr("\n  what changed       " + words + "\n"));
  const json one = figures({"a.png", "far.png"}, 1);
  EXPECT_EQ(one["change"], words);
  EXPECT_EQ(one["places"], json::parse("[[30, 20, 1, 1, 1]]"));
  const json same = figures({"a.png", "same.png"}, 0);
  EXPECT_EQ(same["change"], nullptr);
  EXPECT_EQ(same["places"], json::array());
  save(folder_ / "old/c.png", a_);
  save(folder_ / "new/c.png", grey({64, 48}, 200));
  EXPECT_THAT(diff({"old", "new"}).out, HasSubstr("; brighter by 100 everywhere\n"));
}

// A page names files by URLs relative to its own folder. RFC 3986 escapes all characters except letters, digits
// and "-._~".
TEST_F(DiffCommand, LinksFilesRelativeToTheReportsFolder) {
  const std::string name = "a b?#%é'.png";
  for (const char* side : {"old/", "new/"}) save(folder_ / (side + name), a_);
  std::filesystem::create_directories(folder_ / "pages");
  EXPECT_EQ(diff({"old", "new", "--report", "pages/r.html"}).exitCode, 0);
  EXPECT_EQ(dataOf(bytesOf(folder_ / "pages/r.html"))["entries"][0]["reference"],
            "../old/a%20b%3F%23%25%C3%A9%27.png");
}

TEST_F(DiffCommand, RemovesMapsOfAnEarlierRun) {
  save(folder_ / "old/a.png", a_);
  save(folder_ / "new/a.png", grey({64, 48}, 200));
  EXPECT_EQ(diff({"old", "new", "--map", "maps"}).exitCode, 1);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "maps/a.png"));
  save(folder_ / "new/a.png", a_);
  EXPECT_EQ(diff({"old", "new", "--map", "maps"}).exitCode, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps/a.png"));
}

TEST_F(DiffCommand, FindsPngsWithUpperCaseExtension) {
  save(folder_ / "old/X.PNG", a_);
  save(folder_ / "new/X.PNG", grey({64, 48}, 200));
  EXPECT_EQ(diff({"old", "new"}).exitCode, 1);
}

// In a report of 105 rows that are not identical, only the hundred worst embed pictures: the rows of another size
// or without a partner, and the 97 pairs that differ most.
TEST_F(DiffCommand, EmbedsOnlyTheHundredWorstPairsInTheReport) {
  for (int k = 0; k <= 101; ++k) {
    const std::string name = "p" + std::to_string(k) + ".png";
    save(folder_ / "old" / name, grey({4, 3}, 60));
    save(folder_ / "new" / name, grey({4, 3}, 60 + k));
  }
  save(folder_ / "old/size.png", grey({4, 3}, 60));
  save(folder_ / "new/size.png", grey({3, 4}, 60));
  save(folder_ / "old/gone.png", a_);
  save(folder_ / "new/more.png", a_);
  EXPECT_EQ(diff({"old", "new", "--report", "r.html", "--max", "0-3", "--pixels", "0-100%", "--flip-mean", "0-1",
                  "--flip-max", "0-1"})
                .exitCode,
            1);
  const json page = dataOf(bytesOf(folder_ / "r.html"));
  EXPECT_EQ(page["verdict"], "different");
  ASSERT_EQ(page["entries"].size(), 105u);
  std::map<std::string, json> entries;
  for (const json& entry : page["entries"]) entries[entry["name"]] = entry;
  EXPECT_EQ(entries["size.png"]["message"], "the size is 3x4, not 4x3");
  EXPECT_EQ(entries["gone.png"]["status"], "missing");
  EXPECT_EQ(entries["more.png"]["status"], "new");
  for (const char* shown : {"size.png", "p101.png", "p5.png"})
    EXPECT_THAT(entries[shown]["actual"].dump(), StartsWith("\"data:image/png;base64,")) << shown;
  for (const char* left : {"p1.png", "p2.png", "p4.png"}) {
    EXPECT_EQ(entries[left]["actual"], "new/" + std::string(left)) << "loaded from its file";
    EXPECT_EQ(entries[left]["flip"], nullptr);
  }
  EXPECT_EQ(entries["p0.png"]["reference"], "old/p0.png");
  EXPECT_EQ(entries["p0.png"]["actual"], nullptr) << "the same as the reference";
  EXPECT_EQ(entries["size.png"]["flip"], nullptr);
  EXPECT_NE(entries["p5.png"]["flip"], nullptr);
  EXPECT_THAT(entries["gone.png"]["reference"].dump(), StartsWith("\"data:image/png;base64,"));
  EXPECT_EQ(entries["gone.png"]["actual"], nullptr);
  EXPECT_THAT(entries["more.png"]["actual"].dump(), StartsWith("\"data:image/png;base64,"));
  EXPECT_EQ(entries["more.png"]["reference"], nullptr);
}

TEST_F(DiffCommand, DoesNotReplaceFilesThatItCannotRead) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  folder_.put("s.toml", kGoodScene);
  EXPECT_EQ(run(folder_, {"render", "s.toml", "-o", "a.apng", "--frames", "0-1", "--quiet"}).exitCode, 0);
  folder_.put("d.csv", "somebody's");
  ::chmod((folder_ / "d.csv").c_str(), 0);
  ::chmod(folder_.path().c_str(), 0777);
  const ShellResult refused =
      runShell(folder_.path(), "setpriv --reuid=65534 --regid=65534 --clear-groups " POINSOT_PROGRAM
                               " diff a.apng a.apng --curve d.csv");
  if (refused.exitCode == 126) GTEST_SKIP() << "nobody may run the program where it was built: " << refused.out;
  EXPECT_EQ(refused.exitCode, 4) << refused.out;
  EXPECT_EQ(bytesOf(folder_ / "d.csv"), "somebody's");
}

// tests/golden/page_test.py tests the content of the page in a browser; tests/compare/diff_curve_test.cpp tests
// the curve.
TEST_F(DiffCommand, ReplacesItsOwnReportsAndNothingElse) {
  folder_.put("s.toml", kGoodScene);
  EXPECT_EQ(run(folder_, {"render", "s.toml", "-o", "a.apng", "--frames", "0-3", "--quiet"}).exitCode, 0);
  for (const std::string curve : {"c.csv", "c.svg"}) {
    const std::vector<std::string> words{"a.apng", "a.apng", "--curve", curve, "--report", "r.html"};
    EXPECT_EQ(diff(words).exitCode, 0);
    EXPECT_EQ(diff(words).exitCode, 0) << "a second time";
    folder_.put(curve, "somebody's");
    const RunResult refused = diff(words);
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_THAT(refused.err, HasSubstr(curve + ": exists and was not written by poinsot"));
    EXPECT_EQ(bytesOf(folder_ / curve), "somebody's");
  }
  folder_.put("r.html", bytesOf(folder_ / "r.html") + "<p>somebody's");
  EXPECT_EQ(diff({"a.png", "far.png", "--report", "r.html"}).exitCode, 4);
  EXPECT_EQ(diff({"a.png", "far.png", "--report", "r.html", "--force"}).exitCode, 1);
  const RunResult other = diff({"a.apng", "a.apng", "--curve", "c.png"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_THAT(other.err, HasSubstr("curve 'c.png': must be named NAME.csv or NAME.svg"));
  EXPECT_EQ(diff({"a.apng", "a.apng", "--report", "a2.apng"}).exitCode, 2);
  const RunResult twice = diff({"a.apng", "a.apng", "--map", "m.png", "--diff-image", "./m.png"});
  EXPECT_EQ(twice.exitCode, 2);
  EXPECT_THAT(twice.err, HasSubstr("./m.png is the same file as"));
}

}  // namespace
}  // namespace poinsot
