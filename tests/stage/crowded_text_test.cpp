// SPDX-License-Identifier: Apache-2.0
#include "stage/type/crowded_text.h"

#include <gtest/gtest.h>

namespace poinsot::stage {
namespace {

draw::Text textAt(const std::string& tex, glm::vec2 baseline_px) {
  draw::Text text;
  text.tex = tex;
  text.baseline_px = baseline_px;
  text.size_px = 20;
  return text;
}

// Capitals are 0.68 em high, so letters of 20 px are less than 14 px high and each about 15 px wide.
draw::Picture withTexts(const std::vector<draw::Text>& flat, const std::vector<draw::Text>& inPanel = {}) {
  draw::Picture picture;
  picture.size_px = {300, 100};
  picture.texts = flat;
  picture.panels.resize(1);
  picture.panels[0].origin_px = {100, 0};
  picture.panels[0].list.texts = inPanel;
  return picture;
}

TEST(CrowdedText, IsEmptyIfAllTextHasRoom) {
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 50}), textAt("CD", {50, 50}), textAt("EF", {10, 66})})), "");
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 50})}, {textAt("CD", {10, 50})})), "");
}

TEST(CrowdedText, NamesATextThatOverlapsAnother) {
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 50}), textAt("C", {30, 55})})), "C");
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {110, 50})}, {textAt("$\\omega$", {10, 50})})), "ω");
}

TEST(CrowdedText, NamesATextThatLeavesThePicture) {
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 50}), textAt("CD", {280, 50})})), "CD");
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {-9, 50})})), "AB");
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 5})})), "AB");
}

TEST(CrowdedText, IgnoresInvisibleText) {
  draw::Text hidden = textAt("C", {10, 50});
  hidden.opacity = 0;
  EXPECT_EQ(crowdedText(withTexts({textAt("AB", {10, 50}), hidden})), "");
}

}  // namespace
}  // namespace poinsot::stage
