// SPDX-License-Identifier: Apache-2.0
// Tests figures for notes through the whole program: sizes on paper, metadata of files, and replaced files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "image/png_file.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

class StillCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.put("a.toml", std::string(kGoodScene) + "[show]\ntitle = 'Eine Größe $\\omega$'\n");
  }

  RunResult still(std::vector<std::string> words) {
    words.insert(words.begin(), {"still", "a.toml"});
    return run(folder_, words);
  }
  void good(const std::string& name, std::vector<std::string> words = {}) {
    words.insert(words.begin(), {"-o", name, "--width", "50mm", "--dpi", "100"});
    const auto result = still(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
  }
  std::string bytes(const std::string& name) { return bytesOf(folder_ / name); }

  ScratchFolder folder_;
};

std::string chunk(const std::string& png, const std::string& type) {
  const auto number = [&](std::size_t at) {
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(png.at(at + i));
    return n;
  };
  for (std::size_t at = 8; at + 8 < png.size(); at += 12 + number(at))
    if (png.compare(at + 4, 4, type) == 0) return png.substr(at + 8, number(at));
  return "";
}

TEST_F(StillCommand, WritesPaperSizeAndTitleIntoAPng) {
  const auto result = still({"-o", "a.png", "--width", "86mm", "--dpi", "300"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const std::string png = bytes("a.png");
  EXPECT_EQ(image::readPng(folder_ / "a.png").size,
            (image::PixelSize{1016, 572}));  // 86 / 25.4 * 300; 9 / 16 of it
  // 300 / 0.0254 = 11811 = 0x2e23 pixels per metre, both ways.
  EXPECT_EQ(chunk(png, "pHYs"), std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));
  EXPECT_THAT(chunk(png, "iTXt"), StartsWith(std::string("Title\0\0\0\0\0Eine Größe ω", 24)));
}

TEST_F(StillCommand, WritesNoPaperSizeWithoutWidth) {
  EXPECT_EQ(still({"-o", "a.png"}).exitCode, 0);
  EXPECT_EQ(chunk(bytes("a.png"), "pHYs"), "");
  EXPECT_EQ(image::readPng(folder_ / "a.png").size, (image::PixelSize{160, 90}));
}

TEST_F(StillCommand, WritesPngPdfSvgAndTex) {
  for (const char* name : {"a.png", "a.pdf", "a.svg", "a.tex"}) good(name);
  EXPECT_THAT(namesIn(folder_.path()),
              ElementsAre("a-unlabelled.png", "a.pdf", "a.png", "a.svg", "a.tex", "a.toml"));
  EXPECT_THAT(bytes("a.pdf"), StartsWith("%PDF-1.4"));
  EXPECT_THAT(bytes("a.svg"), HasSubstr("<title>Eine Größe ω</title>"));
  EXPECT_THAT(bytes("a.svg"), HasSubstr("width=\"50mm\" height=\"28.173mm\""));  // 197 x 111 pixels
  EXPECT_THAT(bytes("a.tex"), HasSubstr("\\includegraphics[width=141.732bp"));   // 50 / 25.4 * 72
  EXPECT_THAT(bytes("a.tex"), HasSubstr("{a-unlabelled.png}"));
  EXPECT_EQ(image::readPng(folder_ / "a-unlabelled.png").size, (image::PixelSize{197, 111}));
}

// A shape that is only drawn needs neither volume nor centre of mass.
TEST_F(StillCommand, DrawsAMeshWithoutVolume) {
  folder_.put("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.put("wound.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 1 3 2\nf 1 2 4\n");
  for (const char* file : {"flat.obj", "wound.obj"})
    good("mesh.png", {"-D", "show.body.shape=mesh", "-D", std::string("show.body.file=") + file});
}

TEST_F(StillCommand, DryRunPrintsTheSizeAndWritesNothing) {
  const auto plain = still({"-o", "a.pdf", "--dry-run"});
  EXPECT_EQ(plain.exitCode, 0) << plain.err;
  EXPECT_EQ(plain.out, "a.pdf: 86 x 48.36 mm at 600 dpi, 2031x1142 pixels\n");
  // 86 mm in the other units; TeX has 72.27 points per inch.
  for (const char* width : {"8.6cm", "8.6 cm", "3.385826771653543in", "244.6936pt"})
    EXPECT_EQ(still({"-o", "a.pdf", "--dry-run", "--width", width}).out, plain.out) << width;
  EXPECT_EQ(still({"-o", "a.pdf", "--dry-run", "--size", "400x300", "--width", "60mm", "--dpi", "254"}).out,
            "a.pdf: 60 x 45 mm at 254 dpi, 600x450 pixels\n");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

TEST_F(StillCommand, WarnsOfTextThatIsTooSmallOnPaper) {
  folder_.put("a.toml",
              std::string(kGoodScene) + "[[view]]\n[[plot]]\nquantities = ['L_1', 'L_2']\nat = [1, 0]\n");
  const auto said = [&](const std::string& width) {
    return still({"-o", "a.pdf", "--dry-run", "--width", width}).err;
  };
  EXPECT_THAT(said("35mm"),
              MatchesRegex("poinsot: the smallest text is [34]\\.[0-9] pt high, which is hard to read on "
                           "paper; a larger --width or fewer panels make it larger\n"));
  EXPECT_EQ(said("86mm"), "");
}

TEST_F(StillCommand, OmitsTheBackgroundWithOptionTransparent) {
  good("a.png", {"--transparent"});
  const auto clear = image::readPng(folder_ / "a.png");
  ASSERT_EQ(clear.channels, 4);
  EXPECT_EQ(clear.at(0, 0)[3], 0);
  good("a.svg", {"--transparent"});
  EXPECT_EQ(still({"-o", "screen.png", "--transparent"}).exitCode, 0);
  EXPECT_EQ(image::readPng(folder_ / "screen.png").channels, 4);
}

// The cropped picture is a part of the whole picture, found by its pixels. All around, only a narrow margin is
// left.
TEST_F(StillCommand, LeavesOutEmptyBordersWithOptionCrop) {
  folder_.put("a.toml", std::string(kGoodScene) + "[camera]\nzoom = 0.4\n");
  ASSERT_EQ(still({"-o", "whole.png", "--size", "640x360"}).exitCode, 0);
  const auto result = still({"-o", "part.png", "--size", "640x360", "--crop"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const image::Image whole = image::readPng(folder_ / "whole.png"), part = image::readPng(folder_ / "part.png");
  const auto isInk = [&](int x, int y) { return !std::equal(whole.at(x, y), whole.at(x, y) + 3, whole.at(0, 0)); };
  int left = 640, top = 360, right = 0, bottom = 0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 640; ++x)
      if (isInk(x, y))
        left = std::min(left, x), top = std::min(top, y), right = std::max(right, x), bottom = std::max(bottom, y);
  EXPECT_LT(part.size.width, 400);
  EXPECT_NEAR(part.size.width, right - left + 1 + 2 * 8, 3);  // a margin of 1.2 % of 640
  EXPECT_NEAR(part.size.height, bottom - top + 1 + 2 * 8, 3);
  int unlike = 0;
  for (int y = 0; y < part.size.height; ++y)
    for (int x = 0; x < part.size.width; ++x) {
      const auto *one = part.at(x, y), *other = whole.at(x + left - 8, y + top - 8);
      for (int c = 0; c < 3; ++c) unlike += std::abs(one[c] - other[c]) > 8;
    }
  EXPECT_LE(unlike, 40);  // measured 11 samples, on outlines that pass close to a pixel's edge
}

TEST_F(StillCommand, CropsFiguresToTheirOwnSize) {
  const auto widthOf = [&](const std::string& name) {
    const std::string svg = bytes(name);
    const std::size_t at = svg.find("width=\"") + 7;
    return std::stod(svg.substr(at));
  };
  folder_.put("a.toml", std::string(kGoodScene) + "[camera]\nzoom = 0.4\n");
  good("whole.svg");
  good("part.svg", {"--crop"});
  EXPECT_LT(widthOf("part.svg"), 0.7 * widthOf("whole.svg"));
}

TEST_F(StillCommand, WritesTheLabelsOfAnSvgAsText) {
  good("text.svg", {"--svg-text"});
  good("outlines.svg");
  EXPECT_THAT(bytes("text.svg"), HasSubstr("font-family=\"Latin Modern Math"));
  EXPECT_THAT(bytes("outlines.svg"), Not(HasSubstr("Latin Modern Math")));
}

TEST_F(StillCommand, TheSameCommandGivesTheSameBytes) {
  for (const std::string name : {"a.png", "a.pdf"}) {
    good(name);
    const std::string first = bytes(name);
    good(name);
    EXPECT_TRUE(bytes(name) == first) << name;
  }
}

TEST_F(StillCommand, ReplacesForeignFilesOnlyWithForce) {
  for (const std::string name : {"b.pdf", "b.svg", "b.tex", "b-unlabelled.png"}) {
    folder_.put(name, "mine");
    const std::string target = name == "b-unlabelled.png" ? "b.tex" : name;
    const auto refused = still({"-o", target, "--width", "50mm"});
    EXPECT_EQ(refused.exitCode, 4);
    EXPECT_THAT(refused.err, HasSubstr(name + ": exists and was not written by poinsot; --force replaces it"));
    EXPECT_EQ(bytes(name), "mine");
    good(target, {"--force"});
    EXPECT_NE(bytes(name), "mine");
  }
}

TEST_F(StillCommand, DoesNotReplaceAnEditedFigure) {
  good("a.tex");
  const std::string edited = bytes("a.tex") + "% moved a label\n";
  folder_.put("a.tex", edited);
  EXPECT_EQ(still({"-o", "a.tex"}).exitCode, 4);
  EXPECT_EQ(bytes("a.tex"), edited);
}

struct BadStill {
  std::vector<std::string> words;
  std::string says;
};

TEST_F(StillCommand, RejectsInvalidArgumentsWithAnExplanation) {
  const std::string width = "must be a number above 0 with the unit mm, cm, in or pt, such as 86mm";
  const BadStill cases[] = {
      {{"-o", "a.gif"}, "output 'a.gif': a still is one NAME.png, NAME.pdf, NAME.svg or NAME.tex"},
      {{"-o", "a_{frame}.png"}, "a still is one NAME.png, NAME.pdf"},
      {{"-o", "a.mp4"}, "a still is one NAME.png, NAME.pdf"},
      {{"--width", "86"}, "--width '86': " + width},
      {{"--width", "86 miles"}, width},
      {{"--width", "mm"}, width},
      {{"--width", "0mm"}, width},
      {{"--width", "-5mm"}, "--width '-5mm'"},
      {{"--width", "nanmm"}, width},
      {{"--width", "infmm"}, width},
      {{"--width", ""}, "--width: is empty"},
      {{"--width", "400mm"},
       "400 mm at 600 dpi are 9449x5315 pixels; sides must be from 16 to 8192 pixels; use --dpi 520"},
      {{"--width", "15mm", "--dpi", "20"}, "15 mm at 20 dpi are 12x7 pixels"},
      {{"--width", "5mm"},
       "--width '5mm': must be at least 15 mm, because text does not shrink below its size in points"},
      {{"--width", "1e300mm"}, "sides must be from 16 to 8192 pixels"},
      {{"--dpi", "300"}, "--dpi needs --width"},
      {{"--svg-text"}, "--svg-text: possible only for a figure NAME.svg, got out/SCENE.png"},
      {{"--svg-text", "-o", "a.pdf"}, "--svg-text: possible only for a figure NAME.svg, got a.pdf"},
      {{"--width", "86mm", "-q", "4k"},
       "-q: not possible for a picture on paper; set its pixels with --width and --dpi"},
      {{"--width", "86mm", "--dpi", "0"}, "not in range"},
      {{"--width", "86mm", "--dpi", "many"}, "--dpi"},
      {{"-o", "50%.tex"}, "50%-unlabelled.png: LaTeX cannot load a picture whose name has one of"},
  };
  for (const BadStill& bad : cases) {
    const auto result = still(bad.words);
    EXPECT_EQ(result.exitCode, 2) << bad.says << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr(bad.says));
  }
  const auto film = run(folder_, {"render", "a.toml", "-o", "a.pdf"});
  EXPECT_EQ(film.exitCode, 2);
  EXPECT_THAT(film.err, HasSubstr("`poinsot still` writes figures"));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.toml"));
}

// A note reports automatic choices, and settings that are probably a mistake.
TEST_F(StillCommand, NotesAutomaticChoicesAndLikelyMistakes) {
  const auto said = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", "a.png", "--force", "--size", "64x48"});
    const auto result = still(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.err;
  };
  const std::string throwIt = "motion.flight.velocity=[300,0,5]";
  EXPECT_THAT(said({"-D", throwIt}), HasSubstr("the flight path is drawn "));
  EXPECT_THAT(said({"-D", throwIt, "-D", "show.flight.scale=1"}), Not(HasSubstr("flight path")));
  EXPECT_THAT(said({"-D", "style.colors.paper=#000000"}),
              HasSubstr("titles hardly stand out from the paper (contrast"));
  EXPECT_THAT(said({"-D", "style.colors.paper=#000000", "-D", "style.theme=dark"}), Not(HasSubstr("stand out")));
  EXPECT_THAT(said({"-D", "style.colors.paper=#000000", "--quiet"}), testing::IsEmpty());
  EXPECT_THAT(said({"-D", "show.torque=true"}),
              HasSubstr("show.torque has no effect, because no torque acts on the body"));
  EXPECT_THAT(said({"-D", "camera.azimuth=1"}), HasSubstr("camera.azimuth: 1 is in radians (57.3 deg)"));
  EXPECT_THAT(said({"-D", "show.torque=true", "-D", "motion.torque.body=[0,0,0.1]"}),
              Not(HasSubstr("has no effect")));
}

}  // namespace
}  // namespace poinsot
