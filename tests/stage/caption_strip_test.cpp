// SPDX-License-Identifier: Apache-2.0
// Captions: their place, time and number of lines, and that nothing else moves for them.
#include <gmock/gmock.h>

#include "scene_samples.h"
#include "stage/type/caption_strip.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

constexpr glm::ivec2 kSize(960, 540);
const std::string kLong =
    "The energy ellipsoid rolls without slipping on the invariable plane, and its centre stays at the height "
    "$2T / L$ above it.";

std::string caption(double at, const std::string& text, const std::string& more = "") {
  return "[[timeline]]\nat = " + std::to_string(at) + "\ncaption = '" + text + "'\n" + more;
}

std::vector<draw::Text> textsAt(const std::string& timeline, double t) {
  return Stage(sample(timeline)).compose(t, kSize).texts;
}

double width_px(const draw::Text& text) { return text.size_px * text::setTex(text.tex).width_em; }

TEST(Captions, AreCentredNearTheBottom) {
  const auto texts = textsAt(caption(1, "Rolling"), 5);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].tex, "Rolling");
  EXPECT_NEAR(texts[0].baseline_px.x + 0.5 * width_px(texts[0]), 480, 0.01);
  EXPECT_GT(texts[0].baseline_px.y, 0.93 * kSize.y);
  EXPECT_LT(texts[0].baseline_px.y + 0.2f * texts[0].size_px, kSize.y);
}

TEST(Captions, AreBrokenIntoTwoLinesOutsideFormulas) {
  const auto texts = textsAt(caption(1, kLong), 5);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0].tex + " " + texts[1].tex, kLong);
  EXPECT_NEAR(width_px(texts[0]), width_px(texts[1]), 0.15 * kSize.x);
  EXPECT_GT(texts[1].baseline_px.y, texts[0].baseline_px.y + texts[0].size_px);
  const auto formula = textsAt(caption(1, "$a = " + std::string(3, 'b') + " + c$"), 5);
  EXPECT_EQ(formula.size(), 1u);
}

TEST(Captions, AreSetSmallerIfTwoLinesAreTooShort) {
  std::string longest;
  while (longest.size() < 190) longest += "wide words ";
  const auto texts = textsAt(caption(1, longest), 5);
  ASSERT_EQ(texts.size(), 2u);
  for (const draw::Text& text : texts) EXPECT_LE(width_px(text), 0.881 * kSize.x);
}

TEST(Captions, FadeInAndOut) {
  const std::string timeline = caption(2, "A") + caption(6, "B");
  EXPECT_TRUE(textsAt(timeline, 1.9).empty());
  const auto opacityAt = [&](double t) { return textsAt(timeline, t).at(0).opacity; };
  EXPECT_FLOAT_EQ(opacityAt(2.25), 0.5f);
  EXPECT_EQ(opacityAt(2.5), 1);
  EXPECT_FLOAT_EQ(opacityAt(5.85), 0.5f);
  EXPECT_EQ(textsAt(timeline, 5.99).at(0).tex, "A");
  EXPECT_TRUE(textsAt(timeline, 6).empty());
  EXPECT_EQ(textsAt(timeline, 6.3).at(0).tex, "B");
  EXPECT_EQ(opacityAt(10), 1);  // the last caption stays to the end
}

TEST(Captions, AreOpaqueOrAbsentInAStill) {
  const std::string timeline = caption(2, "A") + caption(6, "B");
  const auto still = [&](double t) { return Stage(sample(timeline)).compose(Moment(t, true), kSize).texts; };
  EXPECT_TRUE(still(1.99).empty());
  for (const double t : {2.0, 2.1, 5.95, 6.0, 10.0}) {
    ASSERT_EQ(still(t).size(), 1u) << t;
    EXPECT_EQ(still(t)[0].opacity, 1) << t;
    EXPECT_EQ(still(t)[0].tex, t < 6 ? "A" : "B") << t;
  }
}

TEST(Captions, DoNotMoveTheViews) {
  const Stage stage(sample(caption(2, "A") + caption(6, kLong, "caption_for = 2\n")));
  const draw::Panel first = stage.compose(0, kSize).panels.at(0);
  for (const double t : {0.0, 3.0, 7.0, 9.0}) {
    const draw::Panel panel = stage.compose(t, kSize).panels.at(0);
    EXPECT_EQ(panel.list.camera.eye_V, first.list.camera.eye_V);
    EXPECT_EQ(panel.list.camera.size_px, first.list.camera.size_px);
  }
}

TEST(Captions, HaveAStripBelowTheViews) {
  const draw::Picture picture = Stage(sample(caption(1, kLong))).compose(5, kSize);
  const float panelEnd = picture.panels.at(0).list.camera.size_px.y;
  EXPECT_LT(panelEnd, kSize.y);
  for (const draw::Text& text : picture.texts) EXPECT_GT(text.baseline_px.y - 0.7f * text.size_px, panelEnd);
}

TEST(Captions, TakeNoRoomInAFilmWithoutCaptions) {
  EXPECT_EQ(
      Stage(sample("[[timeline]]\nat = 1\nspeed = 0.5\n")).compose(5, kSize).panels.at(0).list.camera.size_px,
      glm::vec2(kSize));
}

}  // namespace
}  // namespace poinsot::stage
