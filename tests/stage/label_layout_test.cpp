// SPDX-License-Identifier: Apache-2.0
#include "stage/type/label_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "ink.h"

namespace poinsot::stage {
namespace {

draw::DrawList picture() {
  draw::DrawList list;
  list.camera.size_px = {800, 450};
  return list;
}

TEST(LabelLayout, PutsALabelNextToItsAnchor) {
  draw::DrawList list = picture();
  addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {400, 200}, .direction = {1, 0}, .gap_px = 10}}, {});
  const PixelBox ink = inkOf(list.texts.at(0));
  EXPECT_NEAR(ink.left, 410, 0.5);
  EXPECT_NEAR(0.5 * (ink.top + ink.bottom), 200, 0.5);
}

TEST(LabelLayout, LabelsDoNotOverlapFixedText) {
  const std::vector<PixelBox> taken = {{20, 20, 220, 90}, {300, 400, 520, 440}, {700, 200, 780, 260}};
  for (const float x : {0.0f, 60.0f, 215.0f, 410.0f, 730.0f, 800.0f})
    for (const float y : {0.0f, 30.0f, 88.0f, 230.0f, 415.0f, 450.0f})
      for (const glm::vec2 direction : {glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(-1, -1)}) {
        draw::DrawList list = picture();
        addLabels(list,
                  {{.tex = "$2T/L$", .anchor_px = {x, y}, .direction = direction, .gap_px = 5, .size_px = 24}}, {},
                  0, taken);
        const PixelBox ink = inkOf(list.texts.at(0));
        EXPECT_TRUE(ink.left >= 0 && ink.top >= 0 && ink.right <= 800 && ink.bottom <= 450) << x << ", " << y;
        for (const PixelBox& box : taken) EXPECT_FALSE(near(ink, box)) << x << ", " << y;
      }
}

// Type lies over the middle of the picture. A label goes round the type by the shortest way and stays beside its
// arrow, which ends just left of the type here.
TEST(LabelLayout, LabelsStayNextToTheirArrowsDespiteFixedText) {
  const std::vector<PixelBox> taken = {{300, 205, 500, 245}};
  draw::DrawList list = picture();
  addLabels(list,
            {{.tex = "$y$", .anchor_px = {310, 215}, .direction = {-1, 0}, .gap_px = 5, .size_px = 24},
             {.tex = "$x$", .anchor_px = {450, 240}, .direction = {1, 0}, .gap_px = 5, .size_px = 24}},
            {}, 0, taken);
  EXPECT_LT(inkOf(list.texts.at(0)).right, 300);
  EXPECT_GT(inkOf(list.texts.at(1)).top, 245);
}

// A label is opaque at the border, absent one type size outside, and fades between the two.
TEST(LabelLayout, LabelsFadeOutWithAnchorsThatLeaveThePicture) {
  const auto opacity = [](glm::vec2 anchor_px) {
    draw::DrawList list = picture();
    addLabels(list, {{.tex = "$x$", .anchor_px = anchor_px, .size_px = 20}}, {});
    return list.texts.empty() ? 0 : list.texts.at(0).opacity;
  };
  EXPECT_EQ(opacity({0, 0}), 1);
  EXPECT_EQ(opacity({800, 450}), 1);
  EXPECT_FLOAT_EQ(opacity({-5, 200}), 0.75);
  EXPECT_FLOAT_EQ(opacity({805, 465}), 0.25);
  EXPECT_EQ(opacity({300, 470}), 0);
  EXPECT_EQ(opacity({-900, 100}), 0);
}

/// Returns a shaft seen from straight above, 100 px to a unit, with the origin in the middle of the picture.
draw::DrawList withShaft(glm::vec3 from_W, glm::vec3 to_W) {
  draw::DrawList list;
  list.camera = draw::orthographic(draw::lookAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.8f, {800, 450}), {0, 0, 0});
  list.camera.halfHeight_V = 2.25f;
  draw::Curve& shaft = list.curves.emplace_back();
  shaft.points_V = {from_W, to_W};
  shaft.radius_V = 0.03f;
  return list;
}

// An upright shaft, 6 px wide, runs through x = 410 px; the label would lie at 400 px.
TEST(LabelLayout, ALabelMovesOffAnArrowShaft) {
  draw::DrawList list = withShaft({0.1f, -2, 0}, {0.1f, 2, 0});
  addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {410, 200}, .direction = {-1, 0}, .gap_px = -4}}, {});
  EXPECT_LT(inkOf(list.texts.at(0)).right, 407);
}

// Six shafts are in nearly one place, as L, omega and the axes are in steady spin. The label leaves them, and is
// not pushed away six times as far.
TEST(LabelLayout, SeveralShaftsPushALabelOnlyAsFarAsTwo) {
  const auto leftOf = [](int shafts) {
    draw::DrawList list = withShaft({0.1f, -2, 0}, {0.1f, 2, 0});
    for (int i = 1; i < shafts; ++i) list.curves.push_back(list.curves.front());
    addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {410, 200}, .direction = {-1, 0}, .gap_px = -4}}, {});
    return inkOf(list.texts.at(0)).left;
  };
  EXPECT_LT(leftOf(2), leftOf(1));
  EXPECT_EQ(leftOf(6), leftOf(2));
}

TEST(LabelLayout, ALabelAtTheTipStaysThere) {
  draw::DrawList list = withShaft({0, -2, 0}, {0, 0, 0});
  addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {400, 225}, .direction = {0, -1}, .gap_px = 10}}, {});
  const PixelBox ink = inkOf(list.texts.at(0));
  EXPECT_NEAR(0.5 * (ink.left + ink.right), 400, 0.5);
  EXPECT_NEAR(ink.bottom, 215, 0.5);
}

// A shaft sweeps over a label in steps of half a pixel: the label glides without jumps.
TEST(LabelLayout, LabelsGlideAsAShaftPasses) {
  double before = 0, worst = 0;
  for (int step = 0; step <= 160; ++step) {
    const float x = -0.4f + 0.005f * static_cast<float>(step);
    draw::DrawList list = withShaft({x, -2, 0}, {x, 2, 0});
    addLabels(list, {{.tex = "$\\mathbf{L}$", .anchor_px = {400, 210}, .direction = {0, -1}, .gap_px = 10}}, {});
    const double left = inkOf(list.texts.at(0)).left;
    if (step > 0) worst = std::max(worst, std::abs(left - before));
    before = left;
  }
  EXPECT_LT(worst, 2);  // measured 1.6
  RecordProperty("largest_step_px", std::to_string(worst));
  std::printf("largest step %g px\n", worst);
}

// Two labels close side by side would read as a product.
TEST(LabelLayout, LabelsSideBySideAreSpacedWiderThanAFormula) {
  draw::DrawList list = picture();
  addLabels(list,
            {{.tex = "$L$", .anchor_px = {400, 225}, .direction = {-1, 0}, .size_px = 40},
             {.tex = "$M$", .anchor_px = {400, 225}, .direction = {1, 0}, .size_px = 40}},
            {});
  EXPECT_NEAR(inkOf(list.texts.at(1)).left - inkOf(list.texts.at(0)).right, 0.6 * 40, 0.1);
}

TEST(LabelLayout, LabelsStayInsideThePictureWithoutOverlap) {
  std::mt19937_64 engine(7);
  const auto uniform = [&](double most) {
    return static_cast<float>(most * static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  for (int trial = 0; trial < 300; ++trial) {
    draw::DrawList list = picture();
    std::vector<Label> labels;
    // Five labels around one place in the picture, as when a motion brings all arrows together.
    const glm::vec2 place(uniform(740), uniform(390));
    for (const char* tex : {"$\\mathbf{L}$", "$\\boldsymbol{\\omega}$", "$\\hat{\\mathbf{e}}_1$",
                            "$\\hat{\\mathbf{e}}_2$", "$\\hat{\\mathbf{e}}_3$"})
      labels.push_back({.tex = tex,
                        .anchor_px = place + glm::vec2(uniform(60), uniform(60)),
                        .direction = {uniform(2) - 1, uniform(2) - 1},
                        .gap_px = 8,
                        .size_px = 24});
    addLabels(list, labels, {});
    for (std::size_t i = 0; i < list.texts.size(); ++i) {
      const PixelBox a = inkOf(list.texts[i]);
      EXPECT_GE(a.left, 0);
      EXPECT_GE(a.top, 0);
      EXPECT_LE(a.right, 800);
      EXPECT_LE(a.bottom, 450);
      for (std::size_t j = i + 1; j < list.texts.size(); ++j) {
        const PixelBox b = inkOf(list.texts[j]);
        const bool apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
        EXPECT_TRUE(apart) << "trial " << trial << ": " << list.texts[i].tex << " and " << list.texts[j].tex;
      }
    }
  }
}

}  // namespace
}  // namespace poinsot::stage
