// SPDX-License-Identifier: Apache-2.0
// Pictures of several panels, with areas, strokes and type over them.
#include "picture_test.h"
#include "support/back_ends.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::Picture;

class PanelsTest : public PictureTest {
 protected:
  static draw::DrawList viewOf(image::PixelSize size, Color color) {
    draw::DrawList list = emptyList();
    list.camera.size_px = {size.width, size.height};
    list.camera.centre_px = 0.5f * list.camera.size_px;
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(0.4f), {color, 0.3f}});
    draw::GlassEllipsoid glass;
    glass.graticule = draw::Graticule{};
    glass.semiAxes_V = glm::mat3(0.6f);
    list.glassEllipsoids.push_back(glass);
    list.boxes.push_back({{0, 0.5f, 0.3f}, glm::mat3(0.2f), {color, 0.3f}});
    list.texts.push_back({"$L$", {10, 30}, 24, Color(0), 1, std::nullopt, 0});
    return list;
  }

  static Picture paper(Color background = Color(1)) {
    Picture picture;
    picture.size_px = {kSize.width, kSize.height};
    picture.background = background;
    return picture;
  }

  static draw::Area square(float left, float top, float side, Color color, float opacity = 1) {
    return {{{left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}}, color, opacity};
  }

  static void expectColor(const image::Image& picture, int x, int y, Color expected) {
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(picture.at(x, y)[c], draw::srgb8FromLinear(expected[c])) << x << " " << y;
  }
};

const Color kRed(0.6f, 0.02f, 0.02f), kBlue(0.05f, 0.1f, 0.7f);

TEST_F(PanelsTest, TwoPanelsEqualTwoSinglePicturesSideBySide) {
  const image::PixelSize left{120, 160}, right{80, 100};
  const auto a = viewOf(left, kRed), b = viewOf(right, kBlue);
  for (const bool transparent : {false, true}) {
    const RenderOptions options{.transparent = transparent};
    const image::Image alone[2] = {renderer_.render(a, left, options), renderer_.render(b, right, options)};
    Picture both = paper(draw::fromSrgb(0x102030));
    both.panels = {{{0, 0}, a}, {{120, 30}, b}};
    const image::Image whole = renderer_.render(both, options);
    ASSERT_EQ(whole.channels, transparent ? 4 : 3);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        const bool inLeft = x < 120, inRight = !inLeft && y >= 30 && y < 130;
        const std::uint8_t paperColor[4] = {0x10, 0x20, 0x30, 0};
        const std::uint8_t* expected = inLeft    ? alone[0].at(x, y)
                                       : inRight ? alone[1].at(x - 120, y - 30)
                                                 : paperColor;
        ASSERT_TRUE(std::equal(expected, expected + whole.channels, whole.at(x, y))) << x << " " << y;
      }
    }
  }
}

TEST_F(PanelsTest, APanelThatFillsThePictureEqualsItsDrawList) {
  Picture picture = paper();
  picture.panels = {{{0, 0}, viewOf(kSize, kRed)}};
  EXPECT_EQ(renderer_.render(picture), render(viewOf(kSize, kRed)));
}

TEST_F(PanelsTest, PanelsOfManySizesGiveTheSameBytesInAnyOrder) {
  Picture picture = paper();
  for (int i = 0; i < 6; ++i) picture.panels.push_back({{30 * i, 5 * i}, viewOf({30, 40 + 10 * i}, kRed)});
  const image::Image first = renderer_.render(picture);
  EXPECT_EQ(renderer_.render(picture), first);
  std::ranges::reverse(picture.panels);
  EXPECT_EQ(renderer_.render(picture), first);
}

TEST_F(PanelsTest, APanelsTextIsPlacedFromItsCorner) {
  draw::DrawList list = emptyList();
  list.camera.size_px = {80, 60};
  const draw::Text text{"L", {12, 40}, 30, Color(0), 1, std::nullopt, 0};
  list.texts = {text};
  Picture inPanel = paper(), inPicture = paper();
  inPanel.panels = {{{70, 50}, list}};
  inPicture.texts = {text};
  inPicture.texts[0].baseline_px += glm::vec2(70, 50);
  const image::Image picture = renderer_.render(inPanel);
  EXPECT_GT(blackArea(picture), 30);
  EXPECT_EQ(picture, renderer_.render(inPicture));
}

TEST_F(PanelsTest, RefusesAPanelThatLeavesThePicture) {
  for (const glm::ivec2 origin : {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
    Picture picture = paper();
    picture.panels = {{origin, viewOf(kSize, kRed)}};
    EXPECT_THROW(renderer_.render(picture), std::logic_error);
  }
}

TEST_F(PanelsTest, FlatShapesAreDrawnInOrder) {
  Picture picture = paper();
  picture.areas = {square(20, 20, 60, kRed), square(50, 50, 60, kBlue)};
  draw::Stroke line;
  line.points_px = {{0, 60}, {200, 60}};
  line.width_px = 4;
  line.color = Color(0);
  picture.strokes = {line};
  line.points_px = {{60, 0}, {60, 160}};
  line.color = Color(1);
  picture.strokes.push_back(line);
  const image::Image flat = renderer_.render(picture);
  expectColor(flat, 30, 30, kRed);
  expectColor(flat, 70, 70, kBlue);     // the later area over the earlier one
  expectColor(flat, 30, 60, Color(0));  // strokes over areas
  expectColor(flat, 60, 60, Color(1));  // the later over the earlier
  expectColor(flat, 150, 150, Color(1));
}

TEST_F(PanelsTest, FlatShapesAreDrawnOverPanels) {
  Picture picture = paper();
  picture.panels = {{{0, 0}, viewOf(kSize, kRed)}};
  picture.areas = {square(90, 70, 20, kBlue)};
  expectColor(renderer_.render(picture), 100, 80, kBlue);
}

// Expected by hand, with the "over" operator in linear light.
TEST_F(PanelsTest, OpacityBlendsInLinearLight) {
  Picture picture = paper();
  picture.areas = {square(20, 20, 60, kRed, 0.25f)};
  expectColor(renderer_.render(picture), 40, 40, 0.25f * kRed + 0.75f * Color(1));
}

TEST_F(PanelsTest, OnTransparentPaperTheCoverageIsAlpha) {
  Picture picture = paper();
  picture.areas = {square(20, 20.5f, 60, kRed, 0.5f)};
  const image::Image flat = renderer_.render(picture, {.transparent = true});
  ASSERT_EQ(flat.channels, 4);
  EXPECT_EQ(flat.at(5, 5)[3], 0);
  EXPECT_EQ(flat.at(40, 40)[3], 128);
  EXPECT_EQ(flat.at(40, 20)[3], 64);  // half of the pixel
  expectColor(flat, 40, 40, kRed);    // straight alpha
  expectColor(flat, 40, 20, kRed);
}

TEST_F(PanelsTest, UnchangedFlatShapesGiveTheSameBytesAgain) {
  Picture picture = paper();
  picture.areas = {square(20.3f, 20.5f, 60, kRed, 0.5f)};
  draw::Stroke line;
  line.points_px = {{0, 10}, {200, 133}};
  line.dash_px = 8;
  picture.strokes = {line, line};
  const image::Image first = renderer_.render(picture);
  EXPECT_EQ(renderer_.render(picture), first);
  EXPECT_NE(renderer_.render(paper()), first);
  EXPECT_EQ(renderer_.render(picture), first);
  picture.strokes[1].dash_px = 9;  // a new line, not the cached one
  EXPECT_NE(renderer_.render(picture), first);
}

TEST(PanelsOfBackEnds, OsMesaAndEglGiveTheSameBytes) {
  POINSOT_NEEDS_OSMESA();
  gl::pinEnvironment(true);
  const auto pictureOf = [](gl::Backend backend) {
    Picture picture;
    picture.size_px = {300, 160};
    draw::DrawList list;
    list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 0.3f, {150, 160});
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(0.7f), {kRed, 0.3f}});
    picture.panels = {{{0, 0}, list}};
    list.boxes.push_back({glm::vec3(0, 0.2f, 0.1f), glm::mat3(0.8f), {kBlue, 0.3f}});
    picture.panels.push_back({{150, 0}, list});
    draw::Stroke line;
    line.points_px = {{3, 4}, {290, 155}, {20, 130}};
    line.dash_px = 12;
    line.opacity = 0.7f;
    picture.strokes = {line};
    picture.areas = {{{{30, 20}, {280, 90}, {100, 150}}, kBlue, 0.4f}};
    const auto context = gl::openContext(backend);
    return Renderer(*context).render(picture);
  };
  EXPECT_EQ(pictureOf(gl::Backend::kOsMesa), pictureOf(gl::Backend::kEgl));
}

}  // namespace
}  // namespace poinsot::render
