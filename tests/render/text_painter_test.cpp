// SPDX-License-Identifier: Apache-2.0
#include "render/text_painter.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::render {
namespace {

image::Image paper(int channels) {
  image::Image picture({120, 60}, channels);
  if (channels == 3) std::fill(picture.pixels.begin(), picture.pixels.end(), std::uint8_t{255});
  return picture;
}

int darkPixels(const image::Image& picture) {
  int count = 0;
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < picture.size.width; ++x) count += picture.at(x, y)[0] < 40;
  return count;
}

TEST(TextPainter, PaintsInTheGivenColour) {
  image::Image picture = paper(3);
  TextPainter painter;
  painter.paint({{"$\\mathbf{L}$", {20, 50}, 50, draw::fromSrgb(0x0072B2), 1, std::nullopt, 0}}, picture);
  int exact = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 120; ++x)
      exact += picture.at(x, y)[0] == 0x00 && picture.at(x, y)[1] == 0x72 && picture.at(x, y)[2] == 0xB2;
  EXPECT_GT(exact, 150);                 // the stem of a bold L of 50 pixels
  EXPECT_EQ(*picture.at(100, 30), 255);  // nothing far from it
}

TEST(TextPainter, PaintsAHaloAroundTheGlyphs) {
  image::Image busy({120, 60}, 3);  // black all over
  TextPainter painter;
  painter.paint({{"L", {20, 50}, 50, draw::Color(0), 1, draw::Color(1), 4}}, busy);
  EXPECT_LT(darkPixels(busy), 120 * 60 - 300);
}

TEST(TextPainter, PaintsOpaqueGlyphsIntoATransparentPicture) {
  image::Image picture = paper(4);
  TextPainter painter;
  painter.paint({{"L", {20, 50}, 50, draw::Color(0), 1, std::nullopt, 0}}, picture);
  int opaque = 0;
  for (std::size_t i = 3; i < picture.pixels.size(); i += 4) opaque += picture.pixels[i] == 255;
  EXPECT_GT(opaque, 50);
}

// The picture is black and opaque. The paper shows where the halo is, and the ink stays opaque.
TEST(TextPainter, ClearsTheHaloInATransparentPicture) {
  image::Image busy({120, 60}, 4);
  for (std::size_t i = 3; i < busy.pixels.size(); i += 4) busy.pixels[i] = 255;
  TextPainter painter;
  painter.paint({{"L", {20, 50}, 50, draw::fromSrgb(0x0072B2), 1, draw::Color(1), 4}}, busy);
  int holes = 0, ink = 0, white = 0;
  for (int y = 0; y < busy.size.height; ++y)
    for (int x = 0; x < busy.size.width; ++x) {
      const std::uint8_t* p = busy.at(x, y);
      holes += p[3] == 0;
      ink += p[2] == 0xB2 && p[3] == 255;
      white += p[0] > 128 && p[3] > 0;
    }
  EXPECT_GT(holes, 300);  // measured 539
  EXPECT_GT(ink, 100);    // measured 183
  EXPECT_EQ(white, 0);
}

TEST(TextPainter, ClipsTextAtTheEdgeOfThePicture) {
  image::Image picture = paper(3);
  TextPainter painter;
  EXPECT_NO_THROW(painter.paint({{"Long title", {-30, 20}, 50, draw::Color(0), 1, draw::Color(1), 3}}, picture));
  EXPECT_NO_THROW(painter.paint({{"Long title", {90, 70}, 50, draw::Color(0), 1, draw::Color(1), 3}}, picture));
}

TEST(TextPainter, BadTexIsAnError) {
  image::Image picture = paper(3);
  TextPainter painter;
  EXPECT_THROW(painter.paint({{"$\\omgea$", {0, 20}, 20, draw::Color(0), 1, std::nullopt, 0}}, picture),
               core::Error);
}

}  // namespace
}  // namespace poinsot::render
