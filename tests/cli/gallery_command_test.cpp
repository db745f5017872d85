// SPDX-License-Identifier: Apache-2.0
// Tests `gallery` through the whole program with tiny pictures: the scenes, the times, the sheet and the errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "image/png_file.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class GalleryCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_ / "scenes");
    put("a", "still = 1\n");
    put("b", "");
  }

  /// Writes a valid scene of 4 s; `time` has lines for its table [time].
  void put(const std::string& name, const std::string& time) const {
    std::string scene = kGoodScene;
    const std::string table = "[time]\n";
    const auto at = scene.find(table);
    ASSERT_NE(at, std::string::npos);
    folder_.put("scenes/" + name + ".toml", scene.insert(at + table.size(), time));
  }

  RunResult good(const std::vector<std::string>& words) const {
    auto result = run(folder_, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result;
  }

  std::string bytes(const std::string& name) const { return bytesOf(folder_ / name); }

  ScratchFolder folder_;
};

TEST_F(GalleryCommand, MakesAPictureOfEveryScene) {
  const auto result = good({"gallery"});
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, AllOf(HasSubstr("out/gallery/a.png is ready"), HasSubstr("out/gallery/b.png is ready"),
                                HasSubstr("out/gallery/contact_sheet.png is ready")));
  EXPECT_THAT(namesIn(folder_ / "out" / "gallery"), ElementsAre("a.png", "b.png", "contact_sheet.png"));
}

// Oracle: `still` at the same time, which is 1 s if the scene sets `still` and a third of 4 s otherwise.
TEST_F(GalleryCommand, DrawsStillsAtTheDefaultTime) {
  good({"gallery", "-o", "g", "--quiet"});
  good({"still", "scenes/a.toml", "--time", "1", "-o", "a.png"});
  good({"still", "scenes/b.toml", "--time", "1.3333333333333333", "-o", "b.png"});
  good({"still", "scenes/a.toml", "-o", "a_said.png"});
  good({"still", "scenes/b.toml", "-o", "b_said.png"});
  EXPECT_TRUE(bytes("g/a.png") == bytes("a.png"));
  EXPECT_TRUE(bytes("g/b.png") == bytes("b.png"));
  EXPECT_TRUE(bytes("a_said.png") == bytes("a.png"));
  EXPECT_TRUE(bytes("b_said.png") == bytes("b.png"));
  EXPECT_FALSE(bytes("g/a.png") == bytes("g/b.png"));
}

// Compares pixels, because the metadata of a picture names its scene.
TEST_F(GalleryCommand, DrawsTheEndOfTheFilmIfTimeStillIsLater) {
  put("late", "still = 3600\n");
  good({"still", "scenes/late.toml", "-o", "late.png"});
  good({"still", "scenes/a.toml", "--time", "4", "-o", "end.png"});
  EXPECT_EQ(image::readPng(folder_ / "late.png"), image::readPng(folder_ / "end.png"));
}

TEST_F(GalleryCommand, WritesTheSameBytesWithAnyNumberOfWorkers) {
  good({"gallery", "-o", "one", "-j", "1"});
  good({"gallery", "-o", "five", "-j", "5"});
  for (const char* name : {"a.png", "b.png", "contact_sheet.png"})
    EXPECT_TRUE(bytes(std::string("one/") + name) == bytes(std::string("five/") + name)) << name;
}

TEST_F(GalleryCommand, DrawsOnlyTheChosenScenes) {
  good({"gallery", "--only", "b", "-o", "g", "--no-sheet"});
  EXPECT_THAT(namesIn(folder_ / "g"), ElementsAre("b.png"));
  good({"gallery", "scenes/a.toml", "-o", "h", "--size", "48x28"});
  EXPECT_THAT(namesIn(folder_ / "h"), ElementsAre("a.png", "contact_sheet.png"));
  EXPECT_EQ(image::readPng(folder_ / "h" / "a.png").size, (image::PixelSize{48, 28}));
  const auto wrong = run(folder_, {"gallery", "--only", "bb"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--only bb: no such scene; did you mean 'b'?"));
}

TEST_F(GalleryCommand, DrawsOtherScenesIfOneIsInvalid) {
  folder_.put("scenes/aa_bad.toml", "schema = 1\n[body]\nprincipal_moments = [1, 2, 9]\n");
  const auto result = run(folder_, {"gallery", "-o", "g"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("scenes/aa_bad.toml:3:"), HasSubstr("g/b.png is ready")));
  EXPECT_THAT(namesIn(folder_ / "g"), ElementsAre("a.png", "b.png", "contact_sheet.png"));
}

TEST_F(GalleryCommand, DoesNotReplaceAForeignFile) {
  std::filesystem::create_directory(folder_ / "g");
  folder_.put("g/a.png", "a letter");
  const auto result = run(folder_, {"gallery", "-o", "g"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_THAT(result.err, HasSubstr("g/a.png: exists and was not written by poinsot"));
  EXPECT_EQ(bytes("g/a.png"), "a letter");
  EXPECT_THAT(namesIn(folder_ / "g"), ElementsAre("a.png", "b.png", "contact_sheet.png"));
}

TEST_F(GalleryCommand, ReportsMissingScenesAndDuplicateNames) {
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_THAT(run(folder_, {"gallery", "empty"}).err, HasSubstr("empty: contains no scene (NAME.toml)"));
  EXPECT_EQ(run(folder_, {"gallery", "nowhere.toml"}).exitCode, 2);
  EXPECT_THAT(run(folder_, {"gallery", "scenes", "scenes/a.toml"}).err, HasSubstr("another picture"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "gallery" / "a.png"));
}

TEST_F(GalleryCommand, WritesNothingInADryRun) {
  const auto result = good({"gallery", "--dry-run"});
  EXPECT_THAT(result.out, AllOf(HasSubstr("out/gallery/a.png: scenes/a.toml at 1 s of film\n"),
                                HasSubstr("out/gallery/contact_sheet.png\n")));
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("scenes"));
}

// The sheet has each picture at its place, averaged in linear light, and tinted paper around the pictures. Ink
// 0x2B2F36 at 6 % on white is 0xF8 or darker in sRGB; white is 0xFF.
TEST_F(GalleryCommand, DrawsTheContactSheetWithMargins) {
  good({"gallery", "-o", "g"});
  const auto sheet = image::readPng(folder_ / "g" / "contact_sheet.png");
  EXPECT_EQ(sheet.size, (image::PixelSize{2 * 480 + 3 * 40, 270 + 60 + 2 * 40}));
  const auto paper = std::vector<int>(sheet.at(0, 0), sheet.at(0, 0) + 3);
  EXPECT_THAT(paper, ::testing::Each(AllOf(::testing::Gt(235), ::testing::Lt(255))));
  for (int x = 0; x < sheet.size.width; ++x)
    EXPECT_EQ(std::vector<int>(sheet.at(x, 20), sheet.at(x, 20) + 3), paper) << x;
  const auto picture = image::readPng(folder_ / "g" / "a.png");  // 160x90: not enlarged, centred in its cell
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < picture.size.width; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(sheet.at(40 + 160 + x, 40 + 90 + y)[c], picture.at(x, y)[c]) << x << " " << y;
  int ink = 0;  // pixels of the name under the first picture
  for (int y = 40 + 270; y < 40 + 270 + 60; ++y)
    for (int x = 40; x < 40 + 480; ++x) ink += sheet.at(x, y)[0] < 200 ? 1 : 0;
  EXPECT_GT(ink, 20) << "an a of 24 pixels";  // measured 48
}

// The golden suite draws the scenes that are unchanged since the release.
TEST_F(GalleryCommand, DrawsScenesOfTheFirstRelease) {
  namespace fs = std::filesystem;
  const fs::path source = POINSOT_SOURCE_DIR;
  std::vector<std::string> check{"check"}, draw{"gallery"}, names;
  for (const auto& entry : fs::directory_iterator(source / "tests/scene/released/0.1.0")) {
    const fs::path &file = entry.path(), today = source / "scenes" / file.filename();
    if (file.extension() != ".toml") continue;
    check.push_back(file);
    if (fs::exists(today) && bytesOf(today) == bytesOf(file)) continue;
    draw.push_back(file);
    names.push_back(file.stem().native() + ".png");
  }
  ASSERT_EQ(check.size(), 1u + 29u);
  good(check);
  draw.insert(draw.end(), {"--size", "96x54", "-o", "g", "--no-sheet", "--quiet"});
  good(draw);
  EXPECT_THAT(namesIn(folder_ / "g"), ::testing::UnorderedElementsAreArray(names));
  for (const std::string& name : names) {
    const image::Image picture = image::readPng(folder_ / "g" / name);
    EXPECT_EQ(picture.size, (image::PixelSize{96, 54})) << name;
    const auto paper = picture.pixels.front();
    EXPECT_GT(std::ranges::count_if(picture.pixels, [&](auto value) { return value != paper; }), 96) << name;
  }
}

}  // namespace
}  // namespace poinsot
