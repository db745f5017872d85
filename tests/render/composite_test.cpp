// SPDX-License-Identifier: Apache-2.0
// Checks that translucent sheets compose in the right order from every side. Expected colours are worked out by
// hand, with the "over" operator in linear light.
#include <cmath>

#include "picture_test.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::DrawList;
using glm::vec3;

const Color kRed(0.6f, 0.02f, 0.02f), kBlue(0.05f, 0.1f, 0.7f), kGreen(0.02f, 0.5f, 0.1f);

// The two sheets of a glass body differ in opacity, so that a mix-up shows.
constexpr float kNear = 0.5f, kFar = 1.2f;

class CompositeTest : public PictureTest {
 protected:
  static draw::GlassEllipsoid glass(vec3 centre, float radius, Color color, float opacity) {
    draw::GlassEllipsoid g;
    g.centre_V = centre;
    g.semiAxes_V = glm::mat3(radius);
    g.color = color;
    g.nearOpacity = kNear * opacity;
    g.farOpacity = kFar * opacity;
    g.rimOpacity = opacity;
    return g;
  }

  // Returns a plane that faces the eye, without grid lines.
  static draw::GridPlane facing(float x, Color color, float opacity) {
    draw::GridPlane p;
    p.centre_V = {x, 0, 0};
    p.u_V = {0, 0.5f, 0};
    p.v_V = {0, 0, 0.5f};
    p.color = color;
    p.opacity = opacity;
    p.lineOpacity = 0;
    return p;
  }

  static Color over(Color front, float opacity, Color behind) { return opacity * front + (1 - opacity) * behind; }

  void expectPixel(const DrawList& list, int x, int y, Color expected) {
    const image::Image picture = render(list);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.at(x, y)[c], draw::srgb8FromLinear(expected[c]), 1) << "channel " << c;
  }
};

TEST_F(CompositeTest, EmptyDrawListGivesTheBackgroundColour) {
  DrawList list = emptyList();
  list.background = draw::fromSrgb(0x14171C);
  const image::Image picture = render(list);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
    EXPECT_EQ(picture.pixels[i], 0x14);
    EXPECT_EQ(picture.pixels[i + 1], 0x17);
    EXPECT_EQ(picture.pixels[i + 2], 0x1C);
  }
}

TEST_F(CompositeTest, PlanesAreBlendedInOrderOfDepth) {
  for (const bool swapped : {false, true}) {
    DrawList list = emptyList();
    list.planes = {facing(1, kRed, 0.4f), facing(-1, kBlue, 0.5f)};
    if (swapped) std::swap(list.planes[0], list.planes[1]);
    expectPixel(list, 100, 80, over(kRed, 0.4f, over(kBlue, 0.5f, Color(1))));
  }
}

TEST_F(CompositeTest, ASolidInsideGlassIsCoveredByTheNearSheetOnly) {
  DrawList list = emptyList();
  list.glassEllipsoids = {glass(vec3(0), 0.8f, kRed, 0.3f)};
  list.planes = {facing(0, kBlue, 1.0f)};  // opaque, so as good as a solid
  expectPixel(list, 100, 80, over(kRed, kNear * 0.3f, kBlue));
}

TEST_F(CompositeTest, EmptyGlassShowsItsNearAndFarSheet) {
  DrawList list = emptyList();
  list.glassEllipsoids = {glass(vec3(0), 0.8f, kRed, 0.3f)};
  expectPixel(list, 100, 80, over(kRed, kNear * 0.3f, over(kRed, kFar * 0.3f, Color(1))));
}

TEST_F(CompositeTest, AlternatesSheetsOfIntersectingGlass) {
  for (const float side : {1.0f, -1.0f}) {
    DrawList list = emptyList();
    list.glassEllipsoids = {glass({0.4f * side, 0, 0}, 0.8f, kRed, 0.3f),
                            glass({-0.4f * side, 0, 0}, 0.8f, kBlue, 0.5f)};
    const Color first = side > 0 ? kRed : kBlue, second = side > 0 ? kBlue : kRed;
    const float a = side > 0 ? 0.3f : 0.5f, b = side > 0 ? 0.5f : 0.3f;
    expectPixel(
        list, 100, 80,
        over(first, kNear * a, over(second, kNear * b, over(first, kFar * a, over(second, kFar * b, Color(1))))));
  }
}

TEST_F(CompositeTest, SolidsHideWhatIsBehindThem) {
  DrawList list = emptyList();
  list.ellipsoids.push_back({vec3(0), glm::mat3(0.3f), black()});
  list.planes = {facing(-1, kGreen, 0.9f)};
  list.glassEllipsoids = {glass({-1.5f, 0, 0}, 0.4f, kRed, 0.9f)};
  expectPixel(list, 100, 80, Color(0));
}

// A black edge that covers half a pixel shows half of the plane behind it: the edge blends over what is behind.
TEST_F(CompositeTest, EdgesBlendOverTheSheetsBehindThem) {
  DrawList list = emptyList();
  list.planes = {facing(-1, kRed, 1.0f)};
  draw::Curve line;  // upright, its left edge through the middle of a column of pixels
  line.points_V = {{1, 0.0f, -0.4f}, {1, 0.0f, 0.4f}};
  line.width_px = 4;
  line.material = black();
  list.curves = {line};
  list.camera.centre_px.x += 0.5f;  // the line lies at x = 100.5: it covers 98.5 to 102.5
  expectPixel(list, 98, 80, over(Color(0), 0.5f, kRed));
  expectPixel(list, 100, 80, Color(0));
  expectPixel(list, 97, 80, kRed);
}

TEST_F(CompositeTest, TransparentBackgroundCarriesTheCoverageAsAlpha) {
  DrawList list = emptyList();
  list.planes = {facing(0, kRed, 0.25f)};
  const image::Image picture = renderer_.render(list, kSize, {.transparent = true});
  ASSERT_EQ(picture.channels, 4);
  EXPECT_EQ(picture.at(2, 2)[3], 0);
  EXPECT_NEAR(picture.at(100, 80)[3], 0.25 * 255, 1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(100, 80)[c], draw::srgb8FromLinear(kRed[c]), 1);
}

TEST_F(CompositeTest, PlacesGridLinesAtMultiplesOfTheSpacing) {
  DrawList list = emptyList();
  draw::GridPlane plane = facing(0, Color(1), 1.0f);
  plane.lineColor = Color(0);
  plane.lineOpacity = 1;
  plane.lineWidth_px = 2;
  plane.spacing_V = 0.25f;  // 20 pixels
  list.planes = {plane};
  list.camera.centre_px += 0.5f;
  const image::Image picture = render(list);
  EXPECT_EQ(*picture.at(100, 90), 0);  // x = 100: through the centre
  EXPECT_EQ(*picture.at(120, 90), 0);
  EXPECT_EQ(*picture.at(110, 90), 255);  // between lines
  EXPECT_EQ(*picture.at(110, 100), 0);   // y = 80 + 20
}

}  // namespace
}  // namespace poinsot::render
