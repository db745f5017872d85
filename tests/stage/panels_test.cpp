// SPDX-License-Identifier: Apache-2.0
// Views, plots, read-outs and notes in one picture, checked as values: no GL, no pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ink.h"
#include "scene_samples.h"

namespace poinsot::stage {
namespace {

using draw::Picture;

constexpr glm::ivec2 kSizes[] = {{1280, 720}, {961, 541}, {500, 800}};
const double kTimes[] = {0, 2.9, 7.3, 10};

const std::string kPlots =
    "[[plot]]\nquantities = [\"omega_1\", \"omega_2\", \"omega_3\"]\ntitle = 'Components'\n[[plot]]\nquantities = "
    "[\"omega_2\"]\nx = \"omega_1\"\nat = [1, 1]\n";
const std::string kWriting =
    "[[readout]]\nquantity = \"t\"\n[[readout]]\nquantity = \"omega\"\n[[readout]]\nquantity = \"T\"\nat = "
    "\"bottom "
    "left\"\n[[note]]\ntext = ['One line,', 'and another']\nat = \"bottom\"\n[[note]]\ntext = 'At the right'\nat "
    "= "
    "\"bottom right\"\n";
const std::string kTitle = "[show]\ntitle = \"A title of some length\"\nsubtitle = \"and what is under it\"\n";
const std::string kTime = "[time]\nduration = 10\nspeed = 1\n";

/// Returns the ink of every text of the picture and of its panels.
std::vector<std::pair<std::string, PixelBox>> inks(const Picture& picture) {
  std::vector<std::pair<std::string, PixelBox>> all;
  for (const draw::Text& text : picture.texts) all.emplace_back(text.tex, inkOf(text));
  for (const draw::Panel& panel : picture.panels)
    for (const draw::Text& text : panel.list.texts)
      if (text.opacity > 0) all.emplace_back(text.tex, inkOf(text, panel.origin_px));
  return all;
}

void expectApartAndInside(const Picture& picture) {
  const auto all = inks(picture);
  const glm::dvec2 size(picture.size_px);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PixelBox& ink = all[i].second;
    EXPECT_TRUE(ink.left >= 0 && ink.top >= 0 && ink.right <= size.x && ink.bottom <= size.y) << all[i].first;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(near(ink, all[j].second)) << all[i].first << " and " << all[j].first;
  }
}

// A wide plot stands beside narrow ones: the numbers at all axes have one size, that of the narrowest plot.
TEST(Panels, PlotsHaveNumbersOfOneSize) {
  const auto sizes = [](const std::string& plots) {
    std::set<float> all;
    for (const draw::Text& text : Stage(sample(kTime + plots)).compose(0, {1280, 720}).texts)
      if (text.tex == "$0$" || text.tex == "$5$") all.insert(text.size_px);
    return all;
  };
  const std::string wide = "[[view]]\n[[plot]]\nquantities = [\"T\"]\nat = [0, 1]\nspan = [5, 1]\n";
  const std::string narrow = "[[plot]]\nquantities = [\"omega_1\", \"omega_2\", \"omega_3\"]\nat = [1, 0]\n";
  const auto alone = sizes(wide), beside = sizes(wide + narrow);
  ASSERT_EQ(alone.size(), 1u);
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_LT(*beside.begin(), *alone.begin());
}

TEST(Panels, TextsAreInsideThePictureWithoutOverlap) {
  for (const std::string& scene : {kTitle + kPlots + kWriting, kTitle + kWriting, kPlots + kWriting, kWriting})
    for (const glm::ivec2 size : kSizes)
      for (const double t : kTimes) {
        SCOPED_TRACE(testing::Message() << size.x << " at " << t << "\n" << scene);
        expectApartAndInside(Stage(sample(kTime + scene)).compose(t, size));
      }
}

TEST(Panels, PlotsAreNextToTheViewInOneColumn) {
  const Picture picture = Stage(sample(kTime + kPlots)).compose(3, {1280, 720});
  ASSERT_EQ(picture.panels.size(), 1u);
  EXPECT_EQ(picture.panels[0].list.camera.size_px, glm::vec2(640, 360));
  std::size_t above = 0, under = 0;
  for (const draw::Stroke& stroke : picture.strokes) {
    const auto low = std::ranges::min(stroke.points_px, {}, &glm::vec2::x).x;
    EXPECT_GE(low, 640 - 1e-3f);
    const auto [top, bottom] = std::ranges::minmax(stroke.points_px, {}, &glm::vec2::y);
    EXPECT_TRUE(bottom.y <= 360 || top.y >= 360 || top.x == bottom.x) << top.y << " to " << bottom.y;
    (bottom.y <= 360 ? above : under) += 1;
  }
  EXPECT_GT(above, 5u);
  EXPECT_GT(under, 5u);
}

TEST(Panels, KeepClearOfNotesAndReadouts) {
  const Picture bare = Stage(sample(kTime + kPlots)).compose(3, {1280, 720});
  const Picture written = Stage(sample(kTime + kPlots + kWriting)).compose(3, {1280, 720});
  const draw::Panel &before = bare.panels[0], &after = written.panels[0];
  EXPECT_EQ(before.origin_px.y, 0);
  EXPECT_GT(after.origin_px.y, 30);
  EXPECT_LT(after.list.camera.size_px.y, before.list.camera.size_px.y - 30);
}

// Type over a single view stands in its corners and takes no room from the view.
TEST(Panels, OneViewFillsThePicture) {
  const Picture picture = Stage(sample(kTime + kWriting)).compose(3, {1280, 720});
  EXPECT_EQ(picture.panels[0].list.camera.size_px, glm::vec2(1280, 720));
  for (const draw::Text& text : picture.texts) EXPECT_TRUE(text.halo) << text.tex;
}

TEST(Panels, PlotsFillThePictureIfViewsAreHidden) {
  const Picture picture = Stage(sample(kTime + "[show]\nviews = false\n" + kPlots)).compose(3, {1280, 720});
  EXPECT_TRUE(picture.panels.empty());
  float left = 1e9f, right = 0;
  for (const draw::Text& text : picture.texts) {
    left = std::min(left, text.baseline_px.x);
    right = std::max(right, text.baseline_px.x);
  }
  EXPECT_LT(left, 640);
  EXPECT_GT(right, 640);
  EXPECT_DOUBLE_EQ(Stage(sample("[show]\nviews = false\n" + kPlots)).speed(),
                   Stage(sample(kPlots)).speed());  // speeds are the same with and without a view
}

TEST(Panels, TextsDoNotMoveWhileDigitsChange) {
  const Stage stage(sample(kTime + kTitle + kPlots + kWriting));
  const Picture first = stage.compose(0, {1280, 720});
  for (const double t : kTimes) {
    const Picture now = stage.compose(t, {1280, 720});
    ASSERT_EQ(now.texts.size(), first.texts.size());
    EXPECT_EQ(now.panels[0].origin_px, first.panels[0].origin_px);
    for (std::size_t i = 0; i < now.texts.size(); ++i) {
      const draw::Text &a = first.texts[i], &b = now.texts[i];
      const auto right = [](const draw::Text& text) {
        return static_cast<double>(text.baseline_px.x) +
               text::setTex(text.tex).width_em * static_cast<double>(text.size_px);
      };
      EXPECT_EQ(a.baseline_px.y, b.baseline_px.y) << a.tex;
      EXPECT_EQ(a.size_px, b.size_px) << a.tex;
      EXPECT_NEAR(right(a), right(b), 1e-3) << a.tex << " and " << b.tex;  // floats
    }
  }
}

TEST(Panels, WriteOneDecimalSign) {
  const Picture picture =
      Stage(sample(kTime + "[show]\nexaggerate_angles = 1.5\n[style]\ndecimal_sign = \"comma\"\n" + kPlots +
                   "[[readout]]\nquantity = \"t\"\n"))
          .compose(3.2, {1280, 720});
  int commas = 0;
  for (const draw::Text& text : picture.texts) {
    EXPECT_EQ(text.tex.find('.'), std::string::npos) << text.tex;
    commas += text.tex.find("{,}") != std::string::npos;
  }
  EXPECT_GT(commas, 5);
}

}  // namespace
}  // namespace poinsot::stage
