// SPDX-License-Identifier: Apache-2.0
// `poinsot diff` as others call it: exit codes, the JSON object, folders, films.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program_run.h"
#include "image/png_file.h"

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

// By hand: 64x48 = 3072 pixels, 9216 values; one pixel went from 100 to 255 in each channel.
TEST_F(DiffCommand, TellsTheFigures) {
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
  EXPECT_THAT(far["beyond"].dump(), HasSubstr("largest difference 155 of 2"));

  const json same = figures({"a.png", "same.png"}, 0);
  EXPECT_EQ(same["verdict"], "identical");
  EXPECT_EQ(same["psnr_db"], nullptr);
  EXPECT_EQ(same["ssim"]["mean"], 1.0);
  EXPECT_EQ(same["flip"]["mean"], 0.0);
}

TEST_F(DiffCommand, NeverResizes) {
  save(folder_ / "wide.png", grey({65, 48}, 100));
  save(folder_ / "alpha.png", grey({64, 48}, 100, 4));
  const RunResult wide = diff({"a.png", "wide.png"});
  EXPECT_EQ(wide.exitCode, 1);
  EXPECT_EQ(wide.out, "different: the size is 65x48, not 64x48\n");
  EXPECT_EQ(diff({"a.png", "alpha.png"}).out, "different: the channels are 4 (RGB and alpha), not 3 (RGB)\n");
  const json alpha = figures({"a.png", "alpha.png"}, 1);
  EXPECT_EQ(alpha["verdict"], "different");
  EXPECT_EQ(alpha["flip"], nullptr);
  EXPECT_EQ(alpha["differing_pixels"], nullptr);
}

TEST_F(DiffCommand, TakesPicturesOfOnePixelAndOfSixteenBits) {
  save(folder_ / "one.png", grey({1, 1}, 5));
  save(folder_ / "two.png", grey({1, 1}, 6));
  const json one = figures({"one.png", "two.png"}, 1);  // all of its pixels differ
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

TEST_F(DiffCommand, LimitsAreRangesFromZero) {
  EXPECT_EQ(diff({"a.png", "far.png", "--max", "0-255", "--flip-mean", "0-1", "--flip-max", "0-1"}).exitCode, 0);
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-0"}).exitCode, 1);
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-0.01%"}).exitCode, 1);  // 0.33 of a pixel
  const RunResult bare = diff({"a.png", "near.png", "--max", "3"});
  EXPECT_EQ(bare.exitCode, 2);
  EXPECT_THAT(bare.err, HasSubstr("--max '3': write 0-3: a limit is a range from 0"));
  for (const char* word : {"0-256", "1-3", "0--1", "x", "0-nan"})
    EXPECT_EQ(diff({"a.png", "near.png", "--max", word}).exitCode, 2) << word;
  EXPECT_EQ(diff({"a.png", "near.png", "--pixels", "0-1.5"}).exitCode, 2);
}

TEST_F(DiffCommand, WritesItsPictures) {
  EXPECT_EQ(diff({"a.png", "far.png", "--map", "map.png", "--diff-image", "d.png"}).exitCode, 1);
  const image::Image map = image::readPng(folder_ / "map.png"), d = image::readPng(folder_ / "d.png");
  EXPECT_EQ(map.size, a_.size);
  EXPECT_GT(map.at(30, 20)[0], 150);
  EXPECT_EQ(map.at(60, 40)[2], 4);  // magma's 0 is #000004
  EXPECT_EQ(d.at(30, 20)[0], 255);
  EXPECT_EQ(d.at(31, 20)[0], 0);
}

TEST_F(DiffCommand, SaysWhatItCannotRead) {
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
  EXPECT_THAT(result.out, StartsWith("different: 1 identical, 1 different\n  different  in/two.png: largest"));
  EXPECT_THAT(result.out, HasSubstr("  missing    gone.png\n  new        more.png\n"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "maps/in/two.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "maps/one.png"));  // identical
  const json both = figures({"old", "new"}, 1);
  EXPECT_EQ(both["pictures"].size(), 2u);
  EXPECT_EQ(both["pictures"][0]["name"], "in/two.png");
  EXPECT_EQ(both["only_in_reference"], json::array({"gone.png"}));
  EXPECT_EQ(figures({"old", "old"}, 0)["verdict"], "identical");
  EXPECT_EQ(diff({"old", "maps/none"}).exitCode, 2);  // a folder and none
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

// What the page shows is tested in a browser (tests/golden/page_test.py), what the curve shows in
// tests/app/diff_curve_test.cpp.
TEST_F(DiffCommand, ReplacesItsOwnReportsAndNothingElse) {
  folder_.put("s.toml", kGoodScene);
  EXPECT_EQ(run(folder_, {"render", "s.toml", "-o", "a.apng", "--frames", "0-3", "--quiet"}).exitCode, 0);
  for (const std::string& curve : {"c.csv", "c.svg"}) {
    const std::vector<std::string> words{"a.apng", "a.apng", "--curve", curve, "--report", "r.html"};
    EXPECT_EQ(diff(words).exitCode, 0);
    EXPECT_EQ(diff(words).exitCode, 0) << "a second time";
    folder_.put(curve, "somebody's");
    const RunResult refused = diff(words);
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_THAT(refused.err, HasSubstr(curve + ": exists and was not written by poinsot"));
    EXPECT_EQ(bytesOf(folder_ / curve), "somebody's");
  }
  folder_.put("r.html", "<!DOCTYPE html>\n<p>somebody's");
  EXPECT_EQ(diff({"a.png", "far.png", "--report", "r.html"}).exitCode, 4);
  EXPECT_EQ(diff({"a.png", "far.png", "--report", "r.html", "--force"}).exitCode, 1);
  const RunResult other = diff({"a.apng", "a.apng", "--curve", "c.png"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_THAT(other.err, HasSubstr("curve 'c.png': works: NAME.csv, NAME.svg"));
}

}  // namespace
}  // namespace poinsot
