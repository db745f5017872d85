// SPDX-License-Identifier: Apache-2.0
// Pictures of 16 bits a sample: exact to 16 bits from black to white, and otherwise equal to pictures of 8 bits.
#include <set>

#include "picture_test.h"
#include "support/back_ends.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::Picture;

/// Returns the sRGB value of IEC 61966-2-1 in 16 bits, from the formula.
double encoded16(double light) {
  return 65535 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

int nearest8(std::uint16_t value) { return (value * 255 + 32767) / 65535; }

class DeepPictureTest : public PictureTest {
 protected:
  static Picture pictureOf(const draw::DrawList& list) {
    Picture picture;
    picture.size_px = {kSize.width, kSize.height};
    picture.background = list.background;
    picture.panels = {{{0, 0}, list}};
    return picture;
  }

  static draw::DrawList ball() {
    draw::DrawList list = emptyList();
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(0.9f), {Color(0.5f, 0.3f, 0.1f), 0.3f}});
    return list;
  }

  /// Returns one thing of every kind: solids that cut each other, glass, a plane with a shadow, areas, strokes,
  /// type.
  static Picture everything() {
    draw::DrawList list = emptyList();
    list.background = draw::fromSrgb(0xF4F6F8);
    list.ellipsoids.push_back({glm::vec3(0), glm::mat3(0.4f), {Color(0.6f, 0.05f, 0.02f), 0.3f}});
    list.boxes.push_back({{0, 0.4f, 0.3f}, glm::mat3(0.25f), {Color(0.02f, 0.1f, 0.5f), 0.3f}});
    draw::GlassEllipsoid glass;
    glass.graticule = draw::Graticule{};
    glass.semiAxes_V = glm::mat3(0.7f);
    list.glassEllipsoids.push_back(glass);
    draw::GridPlane plane;
    plane.centre_V = {0, 0, -0.6f};
    plane.u_V = {1.2f, 0, 0.1f};
    plane.v_V = {0, 1.1f, 0};
    plane.shadowCentre_V = plane.centre_V;
    plane.shadowRadius_V = 0.6f;
    plane.shadowOpacity = 0.4f;
    list.planes.push_back(plane);
    list.texts.push_back({"$\\boldsymbol{\\omega}$", {10, 30}, 24, Color(0), 1, Color(1), 3});
    Picture picture = pictureOf(list);
    picture.areas = {{{{150, 10}, {190, 14}, {170, 60}}, Color(0.1f, 0.4f, 0.1f), 0.3f}};
    draw::Stroke line;
    line.points_px = {{5, 150}, {195, 140}};
    line.color = Color(0.3f, 0.01f, 0.2f);
    picture.strokes = {line};
    picture.texts.push_back({"$L$", {150, 100}, 24, Color(0.02f), 1, std::nullopt, 0});
    return picture;
  }

  static void expectExactly(const image::DeepImage& picture, int x, int y, std::uint32_t srgb) {
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(picture.at(x, y)[c], 257 * (srgb >> (16 - 8 * c) & 0xFF)) << x << " " << y << " " << c;
  }
};

// Measured: no sample differs by more than 1 level. 0.03 % of them differ by 1, where rounding twice goes another
// way.
TEST_F(DeepPictureTest, EqualsTheEightBitPictureWhenRounded) {
  const image::Image eight = renderer_.render(everything());
  const image::DeepImage deep = renderer_.renderDeep(everything());
  ASSERT_EQ(deep.channels, 3);
  ASSERT_EQ(deep.pixels.size(), eight.pixels.size());
  int differing = 0;
  for (std::size_t i = 0; i < deep.pixels.size(); ++i) {
    const int step = std::abs(nearest8(deep.pixels[i]) - eight.pixels[i]);
    ASSERT_LE(step, 1) << i;
    differing += step;
  }
  // The renderer keeps buffers of both kinds; neither picture takes the other's.
  EXPECT_EQ(renderer_.render(everything()), eight);
  EXPECT_EQ(renderer_.renderDeep(everything()), deep);
  EXPECT_LE(differing, 0.002 * static_cast<double>(deep.pixels.size()));
}

// Without paper, 8 bits are coarse where a colour has little alpha, so the test compares the pictures on paper.
// Measured: off by 1.03 of 255 at most.
TEST_F(DeepPictureTest, EqualsTheEightBitPictureIfTransparent) {
  const RenderOptions clear{.transparent = true};
  const image::Image eight = renderer_.render(everything(), clear);
  const image::DeepImage deep = renderer_.renderDeep(everything(), clear);
  ASSERT_EQ(deep.channels, 4);
  ASSERT_EQ(deep.pixels.size(), eight.pixels.size());
  int between = 0;
  double worst = 0;
  for (std::size_t i = 0; i < deep.pixels.size(); i += 4) {
    const std::uint8_t* e = &eight.pixels[i];
    const std::uint16_t* d = &deep.pixels[i];
    ASSERT_LE(std::abs(nearest8(d[3]) - e[3]), 1) << i;
    between += d[3] % 257 != 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = e[3] / 255.0, b = d[3] / 65535.0;
      const double onPaper8 = encoded16(a * static_cast<double>(draw::linearFromSrgb8(e[c])) + 1 - a) / 257;
      const double onPaper = encoded16(b * static_cast<double>(draw::linearFromSrgb16(d[c])) + 1 - b) / 257;
      worst = std::max(worst, std::abs(onPaper8 - onPaper));
    }
  }
  EXPECT_LE(worst, 1.25);
  EXPECT_GT(between, 1000) << "alpha has 16 bits, too";
}

// A widened byte is a multiple of 257. Measured: 7904 levels of red; 99.6 % of the samples are not multiples.
TEST_F(DeepPictureTest, HasMoreThanEightBitsOfLevelsOnAShadedBall) {
  const image::DeepImage deep = renderer_.renderDeep(pictureOf(ball()));
  std::set<int> levels;
  int between = 0, count = 0;
  for (int y = 20; y < 140; ++y)
    for (int x = 60; x < 140; ++x, ++count) {
      levels.insert(deep.at(x, y)[0]);
      between += deep.at(x, y)[0] % 257 != 0;
    }
  EXPECT_GT(levels.size(), 4000u);
  EXPECT_GT(between, 0.98 * count);  // random samples: 256 / 257
}

// Flat parts are exact: paper, a line that no light changes, an area.
TEST_F(DeepPictureTest, ShowsEightBitColoursExactly) {
  for (const std::uint32_t srgb : {0x000000u, 0x010203u, 0x0A0B0Cu, 0x2B2F36u, 0x0072B2u, 0xC75000u, 0xFEFDFFu}) {
    draw::DrawList list = emptyList();
    list.background = draw::fromSrgb(0xFFFFFF - srgb);
    draw::Curve curve;
    curve.points_V = {{0, -0.5f, 0}, {0, 0.5f, 0}};
    curve.width_px = 20;
    curve.material = {draw::fromSrgb(srgb), 0};
    list.curves = {curve};
    Picture picture = pictureOf(list);
    picture.areas = {{{{10, 10}, {40, 10}, {40, 40}, {10, 40}}, draw::fromSrgb(srgb), 1}};
    const image::DeepImage deep = renderer_.renderDeep(picture);
    expectExactly(deep, 5, 5, 0xFFFFFF - srgb);
    expectExactly(deep, 100, 80, srgb);
    expectExactly(deep, 25, 25, srgb);
  }
}

// Near black, a step of linear light in 16 bits is 13 steps of sRGB; light kept in 16 bits would put colours off
// by 6. Measured: off by 0.47, which is rounding.
TEST_F(DeepPictureTest, ShowsDarkColoursWithinRounding) {
  for (const float light : {2e-5f, 1.3e-4f, 7.1e-4f, 2.9e-3f, 0.0117f, 0.05f, 0.3f, 0.77f}) {
    draw::DrawList list = emptyList();
    draw::Curve curve;
    curve.points_V = {{0, -0.5f, 0}, {0, 0.5f, 0}};
    curve.width_px = 20;
    curve.material = {Color(light), 0};
    list.curves = {curve};
    const image::DeepImage deep = renderer_.renderDeep(pictureOf(list));
    EXPECT_NEAR(deep.at(100, 80)[0], encoded16(static_cast<double>(light)), 0.6) << light;
  }
}

// The "over" operator in linear light, for a sheet in the shader, and for an area and half a pixel of it on the
// CPU. Measured: off by 0.61, from rounding and a little from float.
TEST_F(DeepPictureTest, BlendsSheetsAndAreasExactly) {
  draw::DrawList list = emptyList();
  list.background = Color(0.8f, 0.31f, 0.017f);
  draw::GridPlane sheet;
  sheet.u_V = {0, 0.5f, 0};
  sheet.v_V = {0, 0, 0.5f};
  sheet.spacing_V = 10;  // its lines run through the centre only
  sheet.color = Color(0.05f, 0.6f, 0.2f);
  sheet.opacity = 0.37f;
  sheet.lineOpacity = 0;
  list.planes = {sheet};
  Picture picture = pictureOf(list);
  picture.areas = {{{{10, 10.5f}, {40, 10.5f}, {40, 40}, {10, 40}}, sheet.color, 0.37f}};
  const image::DeepImage deep = renderer_.renderDeep(picture);
  const double half = 0.37 * 128 / 255;  // coverage of flat parts has 8 bits
  for (int c = 0; c < 3; ++c) {
    const auto mixed = [&](double share) {
      return encoded16(share * static_cast<double>(sheet.color[c]) +
                       (1 - share) * static_cast<double>(list.background[c]));
    };
    EXPECT_NEAR(deep.at(90, 70)[c], mixed(0.37), 0.75) << c;
    EXPECT_NEAR(deep.at(25, 25)[c], mixed(0.37), 0.75) << c;
    EXPECT_NEAR(deep.at(25, 10)[c], mixed(half), 0.75) << c;
  }
}

TEST_F(DeepPictureTest, DrawsAMovedPanelWithTheSameValues) {
  const Picture one = pictureOf(ball());
  Picture beside = one;
  beside.size_px.x += 7;
  beside.panels[0].origin_px.x = 7;
  const image::DeepImage alone = renderer_.renderDeep(one), placed = renderer_.renderDeep(beside);
  for (int y = 0; y < kSize.height; ++y)
    ASSERT_TRUE(std::equal(alone.at(0, y), alone.at(0, y) + alone.rowSamples(), placed.at(7, y))) << y;
}

TEST_F(DeepPictureTest, OsMesaAndEglDrawTheSameValues) {
  POINSOT_NEEDS_OSMESA();
  const image::DeepImage here = renderer_.renderDeep(everything());
  const auto egl = gl::openContext(gl::Backend::kEgl);
  EXPECT_EQ(Renderer(*egl).renderDeep(everything()), here);
}

}  // namespace
}  // namespace poinsot::render
