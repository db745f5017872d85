// SPDX-License-Identifier: Apache-2.0
// Type and lines have sizes in points, independent of the number of pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot::stage {
namespace {

constexpr const char* kTop =
    "[body]\nprincipal_moments = [1, 2, 2.75]\n[motion]\nomega_body = [0.1, 1.5, 0.2]\n"
    "[show]\ntitle = 'A title'\nsubtitle = 'And what it means'\n";

draw::Picture printed(double dpi, const std::string& more = "") {
  const double width_in = 86 / 25.4;
  const glm::ivec2 size_px(glm::dvec2(width_in * dpi, width_in * dpi * 9 / 16));
  return Stage(scene::parseScene(kTop + more, "top.toml")).compose(1, size_px, printSizing(dpi));
}

std::vector<draw::Text> textsOf(const draw::Picture& picture) {
  std::vector<draw::Text> all = picture.texts;
  for (const draw::Panel& panel : picture.panels)
    all.insert(all.end(), panel.list.texts.begin(), panel.list.texts.end());
  return all;
}

/// Returns the sizes of type in points of 1/72 inch.
std::vector<double> sizes_pt(const draw::Picture& picture, double dpi) {
  std::vector<double> all;
  for (const draw::Text& text : textsOf(picture)) all.push_back(72 / dpi * static_cast<double>(text.size_px));
  return all;
}

TEST(Print, TextIsAsLargeAsInABook) {
  const auto sizes = sizes_pt(printed(600), 600);
  ASSERT_GT(sizes.size(), 6u);
  EXPECT_GE(*std::ranges::min_element(sizes), 6.499);
  EXPECT_LE(*std::ranges::max_element(sizes), 10);
}

TEST(Print, LinesAreAsThickAsInABook) {
  for (const draw::Panel& panel : printed(600).panels)
    for (const draw::Curve& curve : panel.list.curves) {
      if (curve.radius_V > 0) continue;
      EXPECT_GE(curve.width_px * 72 / 600, 0.3f);
      EXPECT_LE(curve.width_px * 72 / 600, 1.8f);  // strongest: the newest part of the herpolhode
    }
}

TEST(Print, ResolutionDoesNotChangeSizesOrPositions) {
  const auto coarse = textsOf(printed(150)), fine = textsOf(printed(600));
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    EXPECT_NEAR(coarse[i].size_px, fine[i].size_px / 4, 0.01);
    EXPECT_LT(glm::distance(coarse[i].baseline_px, fine[i].baseline_px / 4.0f), 1.0f) << fine[i].tex;
  }
}

TEST(Print, TextSizeOfTheStyleScalesAllText) {
  const auto plain = sizes_pt(printed(300), 300);
  const auto large = sizes_pt(printed(300, "[style]\ntext_size = 1.25\n"), 300);
  ASSERT_EQ(plain.size(), large.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(large[i], 1.25 * plain[i], 0.01);
}

// The sizes are worked here: 8/7 and 10/7 of the small size.
TEST(Print, FixedTextHasThreeSizes) {
  const Stage stage(scene::parseScene(
      std::string(kTop) + "[[view]]\n[[plot]]\nquantities = ['L_1']\nat = [1, 0]\n", "top.toml"));
  for (const glm::ivec2 size_px : {glm::ivec2(1000, 500), glm::ivec2(2000, 700)})
    for (const draw::Text& text : textsOf(stage.compose(1, size_px, fixedSizing(300, 30)))) {
      const auto size = static_cast<double>(text.size_px);
      const double nearest = size < 32 ? 30 : size < 38 ? 30 * 8.0 / 7 : 30 * 10.0 / 7;
      EXPECT_NEAR(size, nearest, 1e-4) << text.tex;
    }
}

TEST(Print, NoLabelRunsIntoTheTitle) {
  const draw::Picture picture = printed(300);
  ASSERT_EQ(picture.texts.size(), 2u);
  for (const draw::Text& label : picture.panels.at(0).list.texts)
    EXPECT_GT(label.baseline_px.y - label.size_px, picture.texts[1].baseline_px.y) << label.tex;
}

}  // namespace
}  // namespace poinsot::stage
