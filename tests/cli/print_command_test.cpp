// SPDX-License-Identifier: Apache-2.0
// Figures on paper through the whole program: coordinates for TikZ, one size of text, and notes on thin lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

#include "image/png_file.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

constexpr double kDpi = 200;

struct Point {
  double x = 0, y = 0;
};

/// Returns the place of a coordinate in pixels from the top left corner of the figure, y down.
Point coordinate_px(const std::string& tex, const std::string& name, const image::Image& picture) {
  const std::regex line("\\\\coordinate \\(" + name + "\\) at \\(([-0-9.]+)bp, ([-0-9.]+)bp\\);");
  std::smatch found;
  if (!std::regex_search(tex, found, line)) {
    ADD_FAILURE() << "no coordinate " << name;
    return {};
  }
  return {std::stod(found[1]) * kDpi / 72, picture.size.height - std::stod(found[2]) * kDpi / 72};
}

/// Returns the middle of the highest row of ink between two columns.
Point highestInk(const image::Image& picture, int from, int to) {
  const auto isInk = [&](int x, int y) {
    return std::abs(picture.at(x, y)[0] - picture.at(0, 0)[0]) +
               std::abs(picture.at(x, y)[2] - picture.at(0, 0)[2]) >
           40;
  };
  for (int y = 0; y < picture.size.height; ++y) {
    int first = -1, last = -1;
    for (int x = from; x < to; ++x)
      if (isInk(x, y)) last = x, first = first < 0 ? x : first;
    if (first >= 0) return {0.5 * (first + last + 1), static_cast<double>(y)};
  }
  return {-1, -1};
}

class PrintCommand : public ::testing::Test {
 protected:
  RunResult made(const std::string& command, std::vector<std::string> words) {
    words.insert(words.begin(), {command, "a.toml", "--dpi", "200"});
    return run(folder_, words);
  }
  void good(const std::string& command, const std::vector<std::string>& words) {
    const auto result = made(command, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
  }
  std::string noteOf(const std::string& command, std::vector<std::string> words) {
    words.insert(words.end(), {"--dry-run"});
    const auto result = made(command, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.err;
  }
  /// Returns the sizes of all labels of a figure, as fractions of 10 pt.
  std::set<std::string> sizes(const std::string& name) {
    const std::string tex = bytesOf(folder_ / name);
    const std::regex scale("scale=([0-9.]+)\\*\\\\poinsotscale");
    std::set<std::string> all;
    for (std::sregex_iterator each(tex.begin(), tex.end(), scale), end; each != end; ++each)
      all.insert((*each)[1]);
    return all;
  }
  void expectTipsOfL(const std::string& name, const std::vector<std::string>& coordinates) {
    const std::string tex = bytesOf(folder_ / (name + ".tex"));
    const image::Image picture = image::readPng(folder_ / (name + "-unlabelled.png"));
    const int cells = static_cast<int>(coordinates.size());
    for (int i = 0; i < cells; ++i) {
      const Point at = coordinate_px(tex, coordinates[static_cast<std::size_t>(i)], picture);
      const Point seen = highestInk(picture, i * picture.size.width / cells, (i + 1) * picture.size.width / cells);
      EXPECT_NEAR(at.x, seen.x, 1) << name;
      EXPECT_NEAR(at.y, seen.y, 1.5) << name;  // the arrow's tip is thinner than a pixel
    }
  }

  ScratchFolder folder_;
};

/// Scene of which only the arrow of L is drawn. L points up.
const std::string kOnlyL = std::string(kGoodScene) +
                           "[show]\nellipsoid = false\nplane = false\npolhode = false\nherpolhode = false\n"
                           "contact = false\nbody = false\nprincipal_axes = false\nomega = false\n";

TEST_F(PrintCommand, PutsTheCoordinateOfLAtTheTipOfItsArrow) {
  folder_.put("a.toml", kOnlyL);
  good("still", {"-o", "a.tex"});
  expectTipsOfL("a", {"poinsot-L"});
  good("still", {"-o", "cropped.tex", "--crop"});
  expectTipsOfL("cropped", {"poinsot-L"});
  EXPECT_LT(image::readPng(folder_ / "cropped-unlabelled.png").size.width,
            image::readPng(folder_ / "a-unlabelled.png").size.width);
}

TEST_F(PrintCommand, NumbersTheCoordinatesOfASheet) {
  folder_.put("a.toml", kOnlyL);
  good("sweep", {"-D", "time.start=0..1 s:3", "--columns", "3", "-o", "a.tex"});
  expectTipsOfL("a", {"poinsot-1-L", "poinsot-2-L", "poinsot-3-L"});
  const std::string tex = bytesOf(folder_ / "a.tex");
  EXPECT_THAT(tex, HasSubstr("\n% Coordinates: (poinsot-centre) (poinsot-L) (poinsot-1-centre) (poinsot-1-L) "));
  EXPECT_THAT(tex, Not(HasSubstr("poinsot-4-")));
}

// ---- --type

const std::string kWords = "[style]\ntext_size = 1.3\n[[note]]\ntext = 'A note'\n[[readout]]\nquantity = 'E'\n";
const std::string kShow = "[show]\ntitle = 'A title'\nsubtitle = 'A subtitle'\nspace_axes = true\n";

// 8 pt are 0.8 of 10 pt; titles are 8 * 8/7 pt, L and omega 8 * 10/7 pt.
TEST_F(PrintCommand, SetsOneSizeOfTextInEveryLayout) {
  folder_.put("a.toml", kGoodScene + kWords + kShow);
  good("still", {"-o", "a.tex", "--width", "86mm", "--type", "8pt"});
  EXPECT_THAT(sizes("a.tex"), ElementsAre("0.8000", "0.9143", "1.1429"));
  EXPECT_THAT(bytesOf(folder_ / "a.tex"), HasSubstr("scale=1.1429*\\poinsotscale"));

  folder_.put("a.toml", kGoodScene + kWords + kShow +
                            "[[view]]\ntitle = 'Left'\n[[plot]]\nquantities = ['L_1', "
                            "'L_2']\nat = [1, 0]\ntitle = 'A plot'\n");
  good("still", {"-o", "plot.tex", "--width", "150mm", "--type", "8 pt"});
  EXPECT_THAT(sizes("plot.tex"), ElementsAre("0.8000", "0.9143", "1.1429"));

  folder_.put("a.toml", kGoodScene + kShow);
  good("sweep", {"-D", "time.start=0..1 s:6", "-o", "sheet.tex", "--width", "170mm", "--type", "8pt"});
  EXPECT_THAT(sizes("sheet.tex"), ElementsAre("0.8000", "0.9143", "1.1429"));

  good("sweep", {"--map", "-o", "map.tex", "--width", "120mm", "--type", "8pt", "-D", "show.title="});
  EXPECT_THAT(sizes("map.tex"), ElementsAre("0.8000", "1.1429"));
}

// 2.8222 mm are 8 pt of 1/72 inch, and 8.03 TeX points.
TEST_F(PrintCommand, TakesTheSizeOfTextInOtherUnits) {
  folder_.put("a.toml", kGoodScene + kShow);
  good("still", {"-o", "a.tex", "--type", "2.82222mm"});
  EXPECT_THAT(sizes("a.tex"), ElementsAre("0.8030", "0.9177", "1.1471"));
}

TEST_F(PrintCommand, RejectsSizesOfTextThatItCannotUse) {
  folder_.put("a.toml", kGoodScene);
  for (const char* size : {"8", "2.9pt", "41pt", "0pt", "-8pt", "nan pt", "x", "inf pt", "8 px"}) {
    const auto result = made("still", {"-o", "a.pdf", "--type", size});
    EXPECT_EQ(result.exitCode, 2) << size;
    EXPECT_EQ(result.err, "poinsot: error: --type '" + std::string(size) +
                              "': must be from 3 to 40 pt, with the unit, such as 8pt\n");
  }
  const auto screen = run(folder_, {"still", "a.toml", "-o", "a.png", "--type", "8pt"});
  EXPECT_EQ(screen.exitCode, 2);
  EXPECT_THAT(screen.err, HasSubstr("--type needs --width, the width on paper"));
  for (const char* size : {"3pt", "40pt"})
    EXPECT_EQ(noteOf("still", {"-o", "a.pdf", "--type", size}).find("must"), std::string::npos);
}

TEST_F(PrintCommand, SaysIfTextHasNoRoomInItsSize) {
  folder_.put("a.toml", kGoodScene + kWords + kShow);
  EXPECT_EQ(noteOf("still", {"-o", "a.pdf", "--width", "86mm", "--type", "8pt"}), "");
  EXPECT_THAT(
      noteOf("still", {"-o", "a.pdf", "--width", "20mm", "--type", "20pt"}),
      MatchesRegex("poinsot: --type: the smallest text is [0-9.]+ pt high, because a text of 20 pt is too wide "
                   "for its place; make the figure larger, [^\n]*\n"));
  folder_.put("a.toml",
              std::string(kGoodScene) + "[[view]]\n[[plot]]\nquantities = ['L_1', 'L_2']\nat = [1, 0]\n");
  EXPECT_THAT(noteOf("still", {"-o", "a.pdf", "--width", "50mm", "--type", "12pt"}),
              HasSubstr("poinsot: --type: "));
  for (const char* width : {"15mm", "30mm"})  // does not crash without any room
    EXPECT_THAT(noteOf("still", {"-o", "a.pdf", "--width", width, "--type", "40pt"}),
                HasSubstr("poinsot: --type: "));
}

// ---- thin lines

TEST_F(PrintCommand, SaysIfALineIsTooThinForPrint) {
  folder_.put("a.toml",
              std::string(kGoodScene) + "[[view]]\n[[plot]]\nquantities = ['L_1', 'L_2']\nat = [1, 0]\n");
  const std::vector<std::string> figure{"-o", "a.pdf", "--width", "170mm"};
  EXPECT_EQ(noteOf("still", figure), "");
  auto printed = figure;
  printed.insert(printed.end(), {"-D", "style.theme=print"});
  const std::string note = noteOf("still", printed);
  const std::regex form(
      "poinsot: the thinnest line is 0\\.([0-9]{2}) pt wide; many journals ask for 0\\.25 pt: set "
      "style\\.line_width = ([0-9.]+), or have fewer panels or cells\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_match(note, found, form)) << note;
  EXPECT_LT(std::stoi(found[1]), 25);
  printed.insert(printed.end(), {"-D", "style.line_width=" + std::string(found[2])});
  EXPECT_EQ(noteOf("still", printed), "");
}

}  // namespace
}  // namespace poinsot
