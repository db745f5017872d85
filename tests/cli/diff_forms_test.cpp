// SPDX-License-Identifier: Apache-2.0
// Tests `poinsot diff` on pictures in the formats of other tools, on animations, and with ignored places. All
// files are written chunk by chunk, so that the PNG specification decides which of them are equal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "support/program_run.h"
#include "support/raw_png.h"

namespace poinsot {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

enum ColorType : std::uint8_t { kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6 };

constexpr std::uint32_t kSide = 16;

RawPng square(ColorType type, std::uint8_t depth = 8, std::vector<Bytes> chunks = {}) {
  return {kSide, kSide, depth, type, std::move(chunks)};
}

/// Returns the samples of a square picture; `pixel` returns the samples of one pixel from its index.
template <class Pixel>
Bytes samples(Pixel pixel) {
  Bytes all;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    for (const int v : pixel(static_cast<int>(i))) all.push_back(static_cast<std::uint8_t>(v));
  return all;
}

using Values = std::vector<int>;

class DiffFormats : public ::testing::Test {
 protected:
  RunResult diff(std::vector<std::string> words) {
    words.insert(words.begin(), "diff");
    return run(folder_, words);
  }
  json figures(std::vector<std::string> words) {
    words.emplace_back("--json");
    return json::parse(diff(words).out, nullptr, false);
  }
  void save(const std::string& name, const Bytes& bytes) { saveBytes(folder_ / name, bytes); }

  ScratchFolder folder_;
};

/// Returns one picture of 16 greys in every format that can hold it. The keys are the names that messages give to
/// the formats.
std::map<std::string, Bytes> formsOfOnePicture() {
  const auto level = [](int i) { return 17 * (i % 16); };
  Bytes colors, fourBits;
  for (int k = 0; k < 16; ++k)
    for (int c = 0; c < 3; ++c) colors.push_back(static_cast<std::uint8_t>(17 * k));
  for (int i = 0; i < static_cast<int>(kSide * kSide); i += 2)
    fourBits.push_back(static_cast<std::uint8_t>((i % 16) << 4 | (i + 1) % 16));
  const Bytes palette = pngChunk("PLTE", colors);
  return {
      {"RGB", pngBytes(square(kRgb), samples([&](int i) { return Values(3, level(i)); }))},
      {"RGB and alpha", pngBytes(square(kRgba), samples([&](int i) {
                                   return Values{level(i), level(i), level(i), 255};
                                 }))},
      {"grey", pngBytes(square(kGrey), samples([&](int i) { return Values{level(i)}; }))},
      {"grey and alpha", pngBytes(square(kGreyAlpha), samples([&](int i) {
                                    return Values{level(i), 255};
                                  }))},
      {"palette", pngBytes(square(kPalette, 8, {palette}), samples([](int i) { return Values{i % 16}; }))},
      {"RGB of 16 bits", pngBytes(square(kRgb, 16), samples([&](int i) { return Values(6, level(i)); }))},
      {"grey of 16 bits", pngBytes(square(kGrey, 16), samples([&](int i) { return Values(2, level(i)); }))},
  };
}

// Lossless optimisers choose another way to store the same pixels. Only --exact refuses that.
TEST_F(DiffFormats, IgnoresTheStorageFormatWithoutOptionExact) {
  const auto forms = formsOfOnePicture();
  for (const auto& [name, bytes] : forms) save(name + ".png", bytes);
  for (const auto& [a, bytesA] : forms)
    for (const auto& [b, bytesB] : forms) {
      const RunResult result = diff({a + ".png", b + ".png"});
      EXPECT_EQ(result.exitCode, 0) << a << " / " << b << result.err;
      EXPECT_EQ(result.out, a == b ? "identical\n"
                                   : "identical\n  note               stored as " + b + " instead of " + a +
                                         ", same pixels\n");
      EXPECT_EQ(diff({a + ".png", b + ".png", "--exact", "--quiet"}).exitCode, a == b ? 0 : 1);
    }
}

TEST_F(DiffFormats, GivesTheSameFiguresForEveryFormat) {
  auto forms = formsOfOnePicture();
  save("changed.png",
       pngBytes(square(kRgb), samples([](int i) { return Values(3, i == 40 ? 200 : 17 * (i % 16)); })));
  // Pixel 40 had the level 17 * 8 = 136: it differs by 64 in each of three channels of 256 pixels.
  for (const auto& [name, bytes] : forms) {
    save("form.png", bytes);
    const json made = figures({"form.png", "changed.png"});
    EXPECT_EQ(made["differing_pixels"], 1) << name;
    EXPECT_EQ(made["max_difference"], 64) << name;
    EXPECT_DOUBLE_EQ(made["mean_difference"], 64.0 / 256) << name;
    EXPECT_DOUBLE_EQ(made["rmse"], 64.0 / 16) << name;
    EXPECT_EQ(made["worst_pixels"][0]["x"], 40 % 16) << name;
  }
}

TEST_F(DiffFormats, NotesStorageDifferencesOfAFolderOnce) {
  const auto forms = formsOfOnePicture();
  for (const char* name : {"old/a.png", "old/b.png", "old/c.png", "new/c.png"}) save(name, forms.at("RGB"));
  for (const char* name : {"new/a.png", "new/b.png"}) save(name, forms.at("grey"));
  EXPECT_EQ(diff({"old", "new"}).out,
            "identical: 3 identical\n  note: 2 of 3: stored as grey instead of RGB, same pixels (a.png, b.png)\n");
  EXPECT_EQ(figures({"old", "new"})["pictures"][0]["notes"],
            json::array({"stored as grey instead of RGB, same pixels"}));
  EXPECT_EQ(diff({"old", "new", "--exact", "--quiet"}).exitCode, 1);
}

TEST_F(DiffFormats, IgnoresColoursOfTransparentPixels) {
  const auto hidden = [](int color) {
    return pngBytes(square(kRgba), samples([=](int i) {
                      return i < 64 ? Values{color, color, color, 0} : Values{9, 9, 9, 255};
                    }));
  };
  save("black.png", hidden(0));
  save("white.png", hidden(255));
  EXPECT_EQ(diff({"black.png", "white.png"}).out, "identical\n");
}

// A quarter of a black picture became a hole: only alpha changed. Even with limits that allow any sample, FLIP and
// its map show the hole.
TEST_F(DiffFormats, DetectsAHoleInTheAlphaChannel) {
  const auto black = [](bool hole) {
    return pngBytes(square(kRgba), samples([=](int i) { return Values{0, 0, 0, hole && i < 64 ? 0 : 255}; }));
  };
  save("whole.png", black(false));
  save("hole.png", black(true));
  const RunResult result = diff({"whole.png", "hole.png", "--max", "0-255", "--pixels", "0-100%", "--map",
                                 "map.png", "--diff-image", "d.png"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, StartsWith("different: FLIP mean"));
  save("none.png", pngBytes(square(kRgb), Bytes(kSide * kSide * 3)));
  for (const char* map : {"map.png", "d.png"})
    EXPECT_GE(figures({"none.png", map})["differing_pixels"], 64) << map;
}

TEST_F(DiffFormats, NotesThatColourSpacesDiffer) {
  const Bytes pixels(kSide * kSide * 3, 70);
  save("plain.png", pngBytes(square(kRgb), pixels));
  save("srgb.png", pngBytes(square(kRgb, 8, {pngChunk("sRGB", {0})}), pixels));
  save("p3.png", pngBytes(square(kRgb, 8, {pngChunk("cICP", {12, 13, 0, 1})}), pixels));
  EXPECT_EQ(diff({"plain.png", "srgb.png"}).out, "identical\n");
  const std::string said =
      "identical\n  note               Display P3 (cICP) instead of sRGB; both are compared as sRGB\n";
  EXPECT_EQ(diff({"plain.png", "p3.png"}).out, said);
  EXPECT_EQ(diff({"srgb.png", "p3.png"}).out, said);
  EXPECT_EQ(diff({"p3.png", "p3.png"}).out, "identical\n");
}

Bytes animation(const std::vector<int>& levels, const std::vector<std::uint16_t>& delays_ms) {
  std::vector<Bytes> pictures;
  for (const int level : levels) pictures.emplace_back(kSide * kSide * 3, static_cast<std::uint8_t>(level));
  return apngBytes(square(kRgb), pictures, delays_ms);
}

// Only the third frame differs, and readers of still pictures see only the first.
TEST_F(DiffFormats, ComparesAllFramesOfAnAnimatedPng) {
  const std::vector<std::uint16_t> delays(4, 100);
  for (const char* name : {"a.png", "a.apng", "old/a.png"}) save(name, animation({10, 20, 30, 40}, delays));
  for (const char* name : {"b.png", "b.apng", "new/a.png"}) save(name, animation({10, 20, 200, 40}, delays));
  for (const auto& [a, b] : {std::pair("a.png", "b.png"), {"a.apng", "b.apng"}, {"a.png", "b.apng"}}) {
    const RunResult result = diff({a, b});
    EXPECT_EQ(result.exitCode, 1) << a << b;
    EXPECT_THAT(result.out, HasSubstr("first      frame 2, at 0.200 s, is different")) << a << b;
  }
  EXPECT_EQ(diff({"a.png", "a.apng"}).exitCode, 0);
  const RunResult folders = diff({"old", "new", "--map", "maps"});
  EXPECT_EQ(folders.exitCode, 1);
  EXPECT_THAT(folders.out, HasSubstr("different  a.png: frame 2 at 0.200 s: largest difference 170"));
  save("still.png", pngBytes(square(kRgb), Bytes(kSide * kSide * 3, 10)));
  EXPECT_EQ(diff({"still.png", "a.png"}).out,
            "different: the test is an animation, the reference is a single picture\n");
  EXPECT_EQ(diff({"a.png", "still.png"}).exitCode, 1);
  EXPECT_EQ(diff({"a.png", "nothere.png"}).exitCode, 4);
}

TEST_F(DiffFormats, ComparesTimesOfFrames) {
  save("even.png", animation({10, 20, 30, 40}, {100, 100, 100, 100}));
  save("rest.png", animation({10, 20, 30, 40}, {100, 2000, 100, 100}));
  save("end.png", animation({10, 20, 30, 40}, {100, 100, 100, 2000}));
  save("slow.png", animation({10, 20, 30, 40}, {300, 300, 300, 300}));
  save("near.png", animation({10, 20, 30, 40}, {101, 99, 100, 101}));
  EXPECT_THAT(diff({"even.png", "rest.png"}).out, StartsWith("different: frame 2 is at 2.1 s, not 0.2 s\n"));
  EXPECT_THAT(diff({"even.png", "end.png"}).out,
              StartsWith("different: the last frame is shown for 2 s, not 0.1 s\n"));
  EXPECT_THAT(diff({"even.png", "slow.png"}).out,
              StartsWith("different: the film has 3.333 frames a second, not 10\n"));
  EXPECT_EQ(diff({"even.png", "near.png"}).exitCode, 0);
}

TEST_F(DiffFormats, WritesMapsAndReportsIfOnlyTimesDiffer) {
  save("old/times.png", animation({10, 20, 30, 40}, {100, 100, 100, 100}));
  save("new/times.png", animation({10, 20, 30, 40}, {100, 2000, 100, 100}));
  save("old/count.png", animation({10, 20, 30, 40}, {100, 100, 100, 100}));
  save("new/count.png", animation({10, 20, 30}, {100, 100, 100}));
  const RunResult folders = diff({"old", "new", "--map", "maps", "--diff-image", "d", "--report", "r.html"});
  EXPECT_EQ(folders.exitCode, 1) << folders.err;
  EXPECT_THAT(folders.out, HasSubstr("different  count.png: the film has 3 frames, not 4\n"));
  EXPECT_THAT(folders.out, HasSubstr("different  times.png: frame 2 is at 2.1 s, not 0.2 s\n"));
  EXPECT_THAT(bytesOf(folder_ / "r.html"), HasSubstr("data:image/png;base64,"));
  for (const char* name : {"times.png", "count.png"}) {
    const std::string a = std::string("old/") + name, b = std::string("new/") + name;
    EXPECT_EQ(diff({a, b, "--map", "m.png", "--report", "one.html"}).exitCode, 1);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "m.png"));
  }
}

// The default image, which viewers without animation show, precedes the first frame and belongs to no frame.
TEST_F(DiffFormats, ComparesTheDefaultPictureOfAnAnimation) {
  const auto withDefault = [](int level) {
    return apngBytes(square(kRgb), {Bytes(kSide * kSide * 3, 10), Bytes(kSide * kSide * 3, 20)}, {100, 100},
                     Bytes(kSide * kSide * 3, static_cast<std::uint8_t>(level)));
  };
  save("a.png", withDefault(10));
  save("same.png", withDefault(10));
  save("b.png", withDefault(200));
  EXPECT_EQ(diff({"a.png", "same.png"}).exitCode, 0);
  save("old/a.png", withDefault(10));
  save("new/a.png", withDefault(200));
  for (const auto& [a, b] : {std::pair("a.png", "b.png"), {"old", "new"}}) {
    const RunResult result = diff({a, b});
    EXPECT_EQ(result.exitCode, 1) << a;
    EXPECT_THAT(result.out, HasSubstr("the default picture, which viewers without animation show, is different"));
  }
}

TEST_F(DiffFormats, FindsUpperCaseNamesAndNotesLinksInFolders) {
  save("old/X.APNG", animation({10, 20}, {100, 100}));
  save("new/X.APNG", animation({10, 200}, {100, 100}));
  EXPECT_THAT(diff({"old", "new"}).out, StartsWith("different: 1 different\n"));
  save("new/X.APNG", animation({10, 20}, {100, 100}));
  std::filesystem::create_directory_symlink("..", folder_ / "new/link");
  EXPECT_EQ(diff({"old", "new"}).out,
            "identical: 1 identical\n  note: new/link: is a link to a folder, which is not followed\n");
}

TEST_F(DiffFormats, ReportsAnUnreadablePicture) {
  save("a.png", pngBytes(square(kGrey), Bytes(256, 100)));
  folder_.put("torn.png", "version https://git-lfs.github.com/spec/v1\n");
  const RunResult result = diff({"torn.png", "a.png", "--json", "--junit", "j.xml", "--report", "r.html"});
  EXPECT_EQ(result.exitCode, 4);
  const json made = json::parse(result.out, nullptr, false);
  EXPECT_EQ(made["verdict"], "error");
  EXPECT_EQ(made["size"], nullptr);
  EXPECT_EQ(made["channels"], nullptr);
  EXPECT_THAT(
      bytesOf(folder_ / "j.xml"),
      HasSubstr("<error type=\"error\" message=\"torn.png: not a readable PNG: the file is a Git LFS pointer"));
  EXPECT_THAT(bytesOf(folder_ / "r.html"), HasSubstr("\"status\":\"error\""));
  EXPECT_EQ(diff({"torn.png", "a.png"}).out, "");
}

TEST_F(DiffFormats, PrintsFirstAndWorstFrameOfFilmsAsJson) {
  save("old/a.png", animation({10, 20, 30, 40}, {100, 100, 100, 100}));
  save("new/a.png", animation({10, 20, 200, 250}, {100, 100, 100, 100}));
  const json pair = figures({"old", "new"})["pictures"][0]["film"], films = figures({"old/a.png", "new/a.png"});
  for (const json& film : {pair, films["film"]}) {
    EXPECT_EQ(film["frames"], 4);
    EXPECT_EQ(film["differing_frames"], 2);
    EXPECT_EQ(film["first_frame"], 2);
    EXPECT_NEAR(film["first_time_s"].get<double>(), 0.2, 1e-9);
    EXPECT_EQ(film["worst_frame"], 3);
  }
  EXPECT_EQ(films["worst_frame"], 3);
}

// Frame 1 has the larger mean and is within the limits. A bright dot puts frame 2 far beyond the limits.
TEST_F(DiffFormats, NamesTheFrameFarthestBeyondItsLimitsAsTheWorst) {
  std::vector<Bytes> before(3, Bytes(kSide * kSide * 3, 100)), after = before;
  for (auto& v : after[1]) v = 108;
  for (int c = 0; c < 3; ++c) after[2][static_cast<std::size_t>(c)] = 255;
  save("a.png", apngBytes(square(kRgb), before, {100, 100, 100}));
  save("b.png", apngBytes(square(kRgb), after, {100, 100, 100}));
  const std::vector<std::string> words = {"a.png",  "b.png",       "--max", "0-10",       "--pixels",
                                          "0-100%", "--flip-mean", "0-0.2", "--flip-max", "0-0.2"};
  const json made = figures(words);
  EXPECT_EQ(made["worst_frame"], 2);
  EXPECT_GT(made["frames"][1]["flip"]["mean"], made["frames"][2]["flip"]["mean"]);
  EXPECT_THAT(diff(words).out, HasSubstr("first      frame 2, at 0.200 s, is different"));
}

class DiffRules : public DiffFormats {
 protected:
  /// The top row goes from 100 to 200, and pixel (5, 9) from 100 to 104.
  DiffRules() {
    save("a.png", pngBytes(square(kRgb), Bytes(kSide * kSide * 3, 100)));
    save("b.png", pngBytes(square(kRgb), samples([](int i) {
                             return i < static_cast<int>(kSide) ? Values(3, 200)
                                    : i == 9 * 16 + 5           ? Values(3, 104)
                                                                : Values(3, 100);
                           })));
  }
};

TEST_F(DiffRules, IgnoredRegionsAreNotCompared) {
  EXPECT_EQ(diff({"a.png", "b.png"}).exitCode, 1);
  const json made = figures({"a.png", "b.png", "--ignore", "0,0,16,1"});
  EXPECT_EQ(made["differing_pixels"], 1);
  EXPECT_DOUBLE_EQ(made["differing_share"], 1.0 / 240);
  EXPECT_DOUBLE_EQ(made["ignored_share"], 1.0 / 16);
  const RunResult both = diff({"a.png", "b.png", "--ignore", "0,0,99,1", "--ignore", "5,9,1,1"});
  EXPECT_EQ(both.exitCode, 0);
  EXPECT_EQ(both.out, "identical\n  ignored            6.64 % of the picture\n");
  save("mask.png", pngBytes(square(kGrey), samples([](int i) { return Values{i < 16 ? 255 : 0}; })));
  EXPECT_EQ(figures({"a.png", "b.png", "--mask", "mask.png"})["differing_pixels"], 1);
}

TEST_F(DiffRules, RejectInvalidIgnoredRegionsAndMasks) {
  save("small.png", pngBytes({8, 8, 8, kGrey, {}}, Bytes(64)));
  save("white.png", pngBytes(square(kGrey), Bytes(256, 255)));
  const auto error = [&](const std::vector<std::string>& more, int code = 2) {
    std::vector<std::string> words = {"a.png", "b.png"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = diff(words);
    EXPECT_EQ(result.exitCode, code) << result.out;
    return result.err;
  };
  EXPECT_THAT(error({"--ignore", "16,0,4,4"}),
              HasSubstr("ignore [16, 0, 4, 4]: outside of the picture, whose size is 16x16"));
  EXPECT_THAT(error({"--ignore", "1,2,3"}), HasSubstr("--ignore '1,2,3': write x, y, width and height in pixels"));
  EXPECT_THAT(error({"--ignore", "1,2,0,3"}), HasSubstr("width and height at least 1"));
  EXPECT_THAT(error({"--ignore", "1,2,x,3"}), HasSubstr("write x, y, width and height"));
  EXPECT_THAT(error({"--ignore", "0,0,16,16"}), HasSubstr("nothing is left to compare"));
  EXPECT_THAT(error({"--mask", "white.png"}), HasSubstr("nothing is left to compare"));
  EXPECT_THAT(error({"--mask", "small.png"}),
              HasSubstr("mask small.png: its size is 8x8; the picture's is 16x16"));
  EXPECT_THAT(error({"--mask", "nothere.png"}, 4), HasSubstr("nothere.png"));
}

TEST_F(DiffRules, CountOnlyPixelsBeyondTheLevel) {
  // 17 pixels differ, 16 of them by more than 4.
  EXPECT_EQ(figures({"a.png", "b.png", "--level", "4"})["counted_pixels"], 16);
  const std::vector<std::string> free = {"a.png",       "b.png", "--max",      "0-255",
                                         "--flip-mean", "0-1",   "--flip-max", "0-1"};
  const auto with = [&](const char* level, const char* pixels) {
    auto words = free;
    words.insert(words.end(), {"--level", level, "--pixels", pixels});
    return diff(words);
  };
  EXPECT_EQ(with("3", "0-16").exitCode, 1);
  EXPECT_EQ(with("4", "0-16").exitCode, 0);
  EXPECT_THAT(with("4", "0-3").out, StartsWith("different: pixels beyond level 4 16 (limit 3)\n"));
  EXPECT_THAT(with("4", "0-3").out, HasSubstr("17 of 256 (6.64 %), 16 by more than 4"));
  EXPECT_EQ(with("255", "0-3").exitCode, 2);
}

TEST_F(DiffRules, CanBeChosenByName) {
  save("one.png", pngBytes(square(kRgb), samples([](int i) { return Values(3, i == 7 ? 101 : 100); })));
  EXPECT_EQ(diff({"a.png", "one.png", "--rule", "same"}).exitCode, 1);
  EXPECT_EQ(diff({"a.png", "one.png", "--rule", "near"}).exitCode, 0);
  EXPECT_EQ(diff({"a.png", "one.png", "--rule", "same", "--max", "0-1", "--pixels", "0-1", "--flip-mean", "0-1",
                  "--flip-max", "0-1"})
                .exitCode,
            0);
  const json driver = figures({"a.png", "one.png", "--rule", "other_driver"})["limits"];
  EXPECT_EQ(driver["max_difference"], 255);
  EXPECT_EQ(driver["differing_share"], 1);
  EXPECT_EQ(driver["flip_mean"], 0.02);
  EXPECT_EQ(driver["flip_max"], 0.4);
  EXPECT_THAT(diff({"a.png", "one.png", "--rule", "nere"}).err,
              HasSubstr("known rules: same, near, other_driver"));
}

TEST_F(DiffRules, ExplainInvalidLimits) {
  const auto error = [&](const char* option, const char* value) {
    const RunResult result = diff({"a.png", "b.png", option, value});
    EXPECT_EQ(result.exitCode, 2);
    return result.err;
  };
  EXPECT_THAT(error("--pixels", "50%"), HasSubstr("write 0-50%: a limit is a range from 0"));
  EXPECT_THAT(error("--pixels", "50"), HasSubstr("write 0-50: a limit is a range from 0"));
  EXPECT_THAT(error("--max", "0-50%"), HasSubstr("% is allowed for pixels only"));
  const RunResult all =
      diff({"a.png", "b.png", "--max", "0-255", "--pixels", "0-100%", "--flip-mean", "0-1", "--flip-max", "0-1"});
  EXPECT_EQ(all.exitCode, 2);
  EXPECT_THAT(all.err, HasSubstr("every picture would pass; lower at least one limit"));
}

TEST_F(DiffRules, ReportMissingFilesAndFolders) {
  std::filesystem::create_directory(folder_ / "new");
  for (const auto& [a, b] :
       {std::pair("nothere", "new"), {"nothere.png", "a.png"}, {"new", "nothere"}, {"a.png", "nothere.mp4"}}) {
    const RunResult result = diff({a, b});
    EXPECT_EQ(result.exitCode, 4) << a;
    EXPECT_THAT(result.err, HasSubstr(": No such file or directory")) << a;
    EXPECT_THAT(result.err, HasSubstr("nothere")) << a;
  }
}

class DiffReports : public DiffFormats {
 protected:
  DiffReports() {
    for (const char* name : {"old/same.png", "new/same.png", "old/x[1].png", "old/gone.png", "new/more.png"})
      save(name, flat(100));
    save("new/x[1].png", flat(180));
  }
  static Bytes flat(int level) { return pngBytes(square(kGrey), Bytes(256, static_cast<std::uint8_t>(level))); }
  RunResult approve(const std::string& name, const std::string& ci = "CI=") {
    return run(folder_, {"diff", "old", "new", "--update", name}, Stdout::kFile, {ci});
  }
};

// The expected counts follow from the tests above. GitLab's documentation defines the form of attachments.
TEST_F(DiffReports, AreWrittenAsJUnitAndMarkdown) {
  EXPECT_EQ(diff({"old", "new", "--map", "maps", "--junit", "j.xml", "--markdown", "m.md"}).exitCode, 1);
  const std::string xml = bytesOf(folder_ / "j.xml");
  EXPECT_THAT(xml, HasSubstr("tests=\"4\" failures=\"3\" errors=\"0\""));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"different\" message=\"largest difference 80 (limit 2)"));
  EXPECT_THAT(xml, HasSubstr("approve by poinsot diff old new --update 'x[1].png'"));
  EXPECT_THAT(xml, HasSubstr(">largest difference 80 (limit 2)"));  // GitLab does not show the message attribute
  const std::string here = std::filesystem::canonical(folder_.path()).string();
  EXPECT_THAT(xml, HasSubstr("<system-out>[[ATTACHMENT|" + here + "/new/x[1].png]]\n[[ATTACHMENT|" + here +
                             "/maps/x[1].png]]\n[[ATTACHMENT|" + here + "/old/x[1].png]]\n"));
  run(folder_, {"diff", "old", "new", "--junit", "j.xml"}, Stdout::kFile, {"CI_PROJECT_DIR=" + here});
  EXPECT_THAT(bytesOf(folder_ / "j.xml"), HasSubstr("<system-out>[[ATTACHMENT|new/x[1].png]]\n"));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"missing\""));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"new\""));
  const std::string table = bytesOf(folder_ / "m.md");
  EXPECT_THAT(table, StartsWith("### old and new: failed\n\n1 identical, 1 different, 1 missing, 1 new\n"));
  EXPECT_THAT(table, HasSubstr("| different | x&#91;1&#93;&#46;png | largest difference 80 "));
  EXPECT_THAT(table, HasSubstr("```sh\npoinsot diff old new --update "));
  EXPECT_EQ(diff({"old", "old", "--markdown", "m.md"}).exitCode, 0);
  EXPECT_EQ(bytesOf(folder_ / "m.md"), table + "### old and old: passed\n\n3 identical\n");  // appended
}

// GitHub may give the step summary any name, so a variable names the file.
TEST_F(DiffReports, AppendMarkdownOnlyToMarkdownFiles) {
  const std::string picture = bytesOf(folder_ / "new/x[1].png");
  folder_.put("film.mp4", picture);
  folder_.put("summary", "# Job\n");
  const auto added = [&](const char* file, const std::string& summary = "", const char* more = "--quiet") {
    return run(folder_, {"diff", "old", "old", "--markdown", file, more}, Stdout::kFile,
               {"GITHUB_STEP_SUMMARY=" + summary});
  };
  const RunResult refused = added("film.mp4");
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_EQ(refused.err,
            "poinsot: error: film.mp4: exists and is not a NAME.md, or the file that GITHUB_STEP_SUMMARY names; "
            "--force adds to it\n");
  EXPECT_EQ(bytesOf(folder_ / "film.mp4"), picture);
  EXPECT_EQ(added("summary").exitCode, 4);
  EXPECT_EQ(added("summary", (folder_ / "summary").string()).exitCode, 0);
  EXPECT_THAT(bytesOf(folder_ / "summary"), StartsWith("# Job\n### old and old: passed"));
  EXPECT_EQ(added("film.mp4", "", "--force").exitCode, 0);
  ASSERT_EQ(::mkfifo((folder_ / "pipe.md").c_str(), 0600), 0);
  const RunResult pipe = added("pipe.md");
  EXPECT_EQ(pipe.exitCode, 4);
  EXPECT_THAT(pipe.err, HasSubstr("pipe.md: is a pipe; text is added to regular files"));
}

TEST_F(DiffReports, ApprovePicturesByName) {
  const std::string old = bytesOf(folder_ / "old/x[1].png");
  EXPECT_EQ(approve("x[1].png", "CI=true").exitCode, 2);
  EXPECT_EQ(bytesOf(folder_ / "old/x[1].png"), old);
  const RunResult slip = approve("x[2].png");
  EXPECT_EQ(slip.exitCode, 2);
  EXPECT_THAT(slip.err, HasSubstr("--update x[2].png: no picture has this name; did you mean 'x[1].png'?"));
  const RunResult made = approve("x*");
  EXPECT_EQ(made.exitCode, 0);
  EXPECT_THAT(made.out, StartsWith("old/x[1].png: approved, 256 pixels changed, largest 80"));
  EXPECT_EQ(bytesOf(folder_ / "old/x[1].png"), bytesOf(folder_ / "new/x[1].png"));
  const RunResult rest = approve("*");
  EXPECT_EQ(rest.exitCode, 1);
  EXPECT_EQ(rest.out,
            "missing    gone.png: only in the reference; if the new picture is gone for good, remove "
            "old/gone.png\nold/more.png: approved as the first reference of its test\n");
  EXPECT_EQ(approve("same.png").out, "nothing to approve: all of these are identical\n");
}

}  // namespace
}  // namespace poinsot
