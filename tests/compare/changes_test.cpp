// SPDX-License-Identifier: Apache-2.0
#include "compare/changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "image/noise.h"

namespace poinsot::compare {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0}, kBlue{31, 119, 180}, kOrange{255, 127, 14};

void fill(image::Image& picture, const image::PixelRect& box, const Colour& colour) {
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x)
      for (std::size_t c = 0; c < 3; ++c) picture.at(x, y)[c] = colour[c];
}

image::Image plain(const Colour& colour, image::PixelSize size = {200, 100}) {
  image::Image picture(size, 3);
  fill(picture, image::wholeOf(size), colour);
  return picture;
}

/// Draws an "i" of 9 + 36 = 45 pixels in a box of 3x18, with its dot three rows above its stem.
void drawLetter(image::Image& picture, int left, int top, const Colour& colour = kBlack) {
  fill(picture, {left, top, left + 3, top + 3}, colour);
  fill(picture, {left, top + 6, left + 3, top + 18}, colour);
}

image::Image withLetter(int left, int top) {
  image::Image picture = plain(kWhite);
  drawLetter(picture, left, top);
  return picture;
}

/// Returns a ramp of all 256 grey levels, one to a column.
image::Image ramp() {
  image::Image picture({256, 8}, 3);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 256; ++x)
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<std::uint8_t>(x);
  return picture;
}

image::Image mapped(image::Image picture, const std::function<double(double)>& curve) {
  for (std::uint8_t& v : picture.pixels)
    v = static_cast<std::uint8_t>(std::lround(std::clamp(curve(v), 0.0, 255.0)));
  return picture;
}

std::string words(const image::AnyImage& reference, const image::AnyImage& test) {
  return wordsOf(changesBetween(reference, test));
}

TEST(Changes, AreNoneBetweenIdenticalPictures) {
  const image::Image a = image::noise({37, 23}, 1);
  const Changes changes = changesBetween(a, a);
  EXPECT_EQ(changes.pixels, 0);
  EXPECT_TRUE(changes.places.empty());
  EXPECT_EQ(wordsOf(changes), "");
}

TEST(Changes, ReportPositionAndSizeOfALostLetter) {
  const Changes changes = changesBetween(withLetter(50, 20), plain(kWhite));
  const std::vector<ChangedPlace> expected{{{50, 20, 53, 38}, 45}};
  EXPECT_EQ(changes.places, expected);
  EXPECT_EQ(changes.largest, 255);
  EXPECT_EQ(wordsOf(changes), "45 pixels in one place of 3x18 px at (50, 20), #000000 became #ffffff");
}

TEST(Changes, CountSeparateRegions) {
  image::Image a = withLetter(50, 20);
  fill(a, {150, 70, 154, 74}, kBlack);
  const Changes changes = changesBetween(a, plain(kWhite));
  const std::vector<ChangedPlace> expected{{{50, 20, 53, 38}, 45}, {{150, 70, 154, 74}, 16}};
  EXPECT_EQ(changes.places, expected);
  EXPECT_EQ(changes.box, (image::PixelRect{50, 20, 154, 74}));
  EXPECT_EQ(wordsOf(changes), "61 pixels in 2 places, the largest of 3x18 px at (50, 20), #000000 became #ffffff");
}

// Letters are four pixels apart, so that five of them are 4 * 7 + 3 = 31 pixels wide.
TEST(Changes, CountAWordAsOneRegion) {
  image::Image a = plain(kWhite);
  for (int k = 0; k < 5; ++k) drawLetter(a, 40 + 7 * k, 30);
  const std::vector<ChangedPlace> expected{{{40, 30, 71, 48}, 225}};
  EXPECT_EQ(changesBetween(a, plain(kWhite)).places, expected);
}

TEST(Changes, ReportThePositionOfASinglePixel) {
  image::Image a = plain(kBlue), b = a;
  b.at(7, 5)[1] = 120;
  EXPECT_EQ(words(a, b), "1 pixel at (7, 5), only in green, by at most 1 of 255");
}

// Every sample is random, so that no other shift fits. Pixels that come in at the edge have other colours.
TEST(Changes, FindThatTheWholePictureMoved) {
  const image::Image a = image::noise({120, 90}, 2);
  for (const Shift& shift : {Shift{1, 0}, Shift{0, -1}, Shift{-16, 16}}) {
    image::Image b = image::noise({120, 90}, 3);
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 120; ++x) {
        const int fromX = x - shift.x, fromY = y - shift.y;
        if (fromX >= 0 && fromX < 120 && fromY >= 0 && fromY < 90) std::copy_n(a.at(fromX, fromY), 3, b.at(x, y));
      }
    EXPECT_EQ(changesBetween(a, b).shift, shift) << shift.x << " " << shift.y;
  }
}

TEST(Changes, ReportHowFarThePictureMoved) {
  const image::Image a = image::noise({60, 40}, 2);
  image::Image b = a;
  for (int y = 0; y < 40; ++y) std::copy_n(a.at(0, y), 3 * 59, b.at(1, y));
  EXPECT_EQ(words(a, b), "the picture moved by 1 px to the right");
}

// The letter spans x 50 to 53 and y 20 to 38, and moves by -2 and 3. Old and new together span x 48 to 53 and y 20
// to 41.
TEST(Changes, DetectThatOneRegionMoved) {
  EXPECT_EQ(words(withLetter(50, 20), withLetter(48, 23)),
            "one place of 5x21 px at (48, 20) moved by 2 px to the left and 3 px down");
}

TEST(Changes, DetectThatTheLargestOfSeveralRegionsMoved) {
  image::Image a = withLetter(50, 20), b = withLetter(51, 20);
  fill(b, {150, 70, 153, 73}, kBlack);
  // A column of 15 pixels is uncovered and another covered; the second place has 9 pixels.
  EXPECT_EQ(words(a, b),
            "39 pixels in 2 places, the largest of 4x18 px at (50, 20), which moved by 1 px to the right");
}

TEST(Changes, DetectNoMotionBeyondSixteenPixels) {
  const Changes changes = changesBetween(withLetter(50, 20), withLetter(67, 20));
  EXPECT_FALSE(changes.shift);
  EXPECT_EQ(wordsOf(changes), "90 pixels in 2 places, the largest of 3x18 px at (50, 20)");
}

TEST(Changes, ReportAUniformChangeOfBrightness) {
  EXPECT_EQ(words(ramp(), mapped(ramp(), [](double v) { return v + 2; })), "brighter by 2 everywhere");
  EXPECT_EQ(words(ramp(), mapped(ramp(), [](double v) { return v - 1; })), "darker by 1 everywhere");
  EXPECT_EQ(words(plain({9, 9, 9}), plain({12, 12, 12})), "brighter by 3 everywhere");
  // Black stays black, and red has only the values of black and white.
  image::Image dark = withLetter(50, 20), darker = plain({254, 254, 254});
  fill(dark, {100, 20, 120, 40}, {0, 114, 178});
  drawLetter(darker, 50, 20);
  fill(darker, {100, 20, 120, 40}, {0, 113, 177});
  EXPECT_EQ(words(dark, darker), "darker by 1 everywhere");
  image::Image b = ramp();
  for (std::size_t i = 0; i < b.pixels.size(); i += 3) {
    b.pixels[i] = static_cast<std::uint8_t>(std::min(255, b.pixels[i] + 1));
    b.pixels[i + 2] = static_cast<std::uint8_t>(std::max(0, b.pixels[i + 2] - 4));
  }
  EXPECT_EQ(words(ramp(), b), "red higher by 1, blue lower by 4 everywhere");
}

TEST(Changes, ReportAFactorContrastOrToneCurve) {
  EXPECT_EQ(words(ramp(), mapped(ramp(), [](double v) { return 0.9 * v; })),
            "values multiplied by 0.9 everywhere");
  EXPECT_EQ(words(ramp(), mapped(ramp(), [](double v) { return 127.5 + 1.2 * (v - 127.5); })),
            "contrast multiplied by 1.2 everywhere");
  EXPECT_EQ(words(ramp(), mapped(ramp(), [](double v) { return 255 * std::pow(v / 255, 1 / 1.3); })),
            "another tone curve everywhere");
}

// Each value of the shape becomes one value, that of the ground, which is not a change of tone.
TEST(Changes, DoNotMistakeALostShapeForAChangeOfTone) {
  image::Image a = plain(kWhite);
  for (int k = 0; k < 40; ++k) fill(a, {20 + k, 20, 21 + k, 40}, {std::uint8_t(6 * k), std::uint8_t(6 * k), 0});
  EXPECT_EQ(words(a, plain(kWhite)), "800 pixels in one place of 40x20 px at (20, 20)");
}

// Each line has 2 rows, with a row of half its strength above and below, and is 100 pixels long.
TEST(Changes, ReportTheOldAndTheNewColour) {
  const auto line = [](const Colour& colour) {
    image::Image picture = plain(kWhite);
    const auto half = [](std::uint8_t v) { return static_cast<std::uint8_t>((v + 255) / 2); };
    fill(picture, {40, 49, 140, 53}, {half(colour[0]), half(colour[1]), half(colour[2])});
    fill(picture, {40, 50, 140, 53}, colour);
    return picture;
  };
  EXPECT_EQ(words(line(kBlue), line(kOrange)),
            "400 pixels in one place of 100x4 px at (40, 49), #1f77b4 became #ff7f0e in 300 of them");
}

TEST(Changes, NameTheColourThatFilledAllOfThePicture) {
  EXPECT_EQ(words(plain(kBlue), plain(kOrange)),
            "20000 pixels (100 %) all over the picture, #1f77b4 became #ff7f0e");
}

TEST(Changes, ReportManySmallRegionsAsScattered) {
  image::Image a = plain({100, 100, 100}, {320, 240}), b = a;
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 20; ++i) b.at(16 * i, 24 * j)[(i + j) % 3] += 1;
  EXPECT_EQ(words(a, b), "200 pixels scattered over the whole picture, by at most 1 of 255");
  EXPECT_EQ(changesBetween(a, b).placeCount, 200);
  EXPECT_EQ(changesBetween(a, b).places.size(), Changes::kMostPlaces);
}

TEST(Changes, ReportThatThePictureDiffersEverywhere) {
  image::Image a = image::noise({80, 60}, 4), b = image::noise({80, 60}, 5);
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) b.pixels[i] = static_cast<std::uint8_t>(a.pixels[i] ^ 128);
  EXPECT_EQ(words(a, b), "4800 pixels (100 %) all over the picture");
}

TEST(Changes, ReportThatOnlyOneChannelChanged) {
  image::Image a(image::PixelSize{64, 64}, 4), b = a;
  for (int x = 8; x < 16; ++x) b.at(x, 8)[3] = 255;
  EXPECT_EQ(words(a, b), "8 pixels in one place of 8x1 px at (8, 8), #00000000 became #000000ff, only in alpha");
}

// The step is a quarter of all levels: 0x8080 becomes 0xc080.
TEST(Changes, ReportSixteenBitColoursInHexadecimal) {
  const image::DeepImage a = image::deepened(plain({128, 128, 128}, {20, 20}));
  image::DeepImage b = a;
  b.at(3, 4)[1] += 0x4000;
  EXPECT_EQ(words(a, b), "1 pixel at (3, 4), #808080808080 became #8080c0808080, only in green");
}

// With 16 bits, 0x8080 becomes 0x8081, a difference of 1/257.
TEST(Changes, ReportDifferencesBelowOneEightBitLevel) {
  const image::Image flat = plain({128, 128, 128}, {20, 20});
  image::DeepImage deep = image::deepened(flat);
  EXPECT_EQ(words(flat, deep), "");
  deep.at(3, 4)[1] += 1;
  EXPECT_EQ(words(flat, deep), "1 pixel at (3, 4), only in green, by at most 0.00389 of 255");
}

TEST(Changes, RefusePicturesOfAnotherShape) {
  EXPECT_THROW(changesBetween(image::Image({4, 4}, 3), image::Image({4, 5}, 3)), std::logic_error);
  EXPECT_THROW(changesBetween(image::Image({4, 4}, 3), image::Image({4, 4}, 4)), std::logic_error);
}

image::Image withBar(int height) {
  image::Image picture({200, 100}, 3);
  picture.pixels.assign(picture.pixels.size(), 255);
  for (int y = 100 - height; y < 100; ++y)
    for (int x = 60; x < 120; ++x) std::fill_n(picture.at(x, y), 3, std::uint8_t{40});
  return picture;
}

// A bar that grew by eleven rows fits a move by any number of rows from eleven on, so that no move is reported.
TEST(Changes, DoNotMistakeAGrownRegionForAMovedOne) {
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(withBar(30)), image::AnyImage(withBar(41)))),
            "660 pixels in one place of 60x11 px at (60, 59), #ffffff became #282828");
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(withBar(41)), image::AnyImage(withBar(30)))),
            "660 pixels in one place of 60x11 px at (60, 59), #282828 became #ffffff");
}

image::Image noisy(int seed) {
  image::Image picture({60, 40}, 3);
  unsigned v = static_cast<unsigned>(seed);
  for (auto& sample : picture.pixels) sample = static_cast<std::uint8_t>((v = v * 1664525 + 1013904223) >> 24);
  return picture;
}

TEST(Changes, RecogniseFlippedMirroredAndSwappedPictures) {
  const image::Image a = noisy(1);
  image::Image down(a.size, 3), mirrored(a.size, 3), exchanged(a.size, 3);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      std::copy_n(a.at(x, 39 - y), 3, down.at(x, y));
      std::copy_n(a.at(59 - x, y), 3, mirrored.at(x, y));
      std::reverse_copy(a.at(x, y), a.at(x, y) + 3, exchanged.at(x, y));
    }
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(a), image::AnyImage(down))), "upside down");
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(a), image::AnyImage(mirrored))), "mirrored left to right");
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(a), image::AnyImage(exchanged))),
            "red and blue are exchanged everywhere");
}

TEST(Changes, LeaveIgnoredPixelsOut) {
  const image::Image a = withBar(30);
  image::Image b = a;
  for (auto& v : b.pixels) v = static_cast<std::uint8_t>(v - 2);
  IgnoreMask ignored(a.size);
  ignored.add(image::PixelRect{0, 0, 50, 50});
  const image::Image seen = withIgnoredOf(a, b, ignored);
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(a), image::AnyImage(seen), &ignored)),
            "darker by 2 everywhere");
}

// A fifth of the pixels is enough, because most pixels of a line are smooth edges.
TEST(Changes, ReportAColourThatAFifthOfThePixelsTook) {
  image::Image a({100, 100}, 3), b({100, 100}, 3);
  for (int i = 0; i < 30; ++i) {
    const int x = 10 + i, y = 20;
    a.at(x, y)[0] = 200;
    b.at(x, y)[1] = static_cast<std::uint8_t>(i < 8 ? 100 : 101 + i);  // 8 of 30 became one colour
  }
  EXPECT_EQ(wordsOf(changesBetween(image::AnyImage(a), image::AnyImage(b))),
            "30 pixels in one place of 30x1 px at (10, 20), #c80000 became #006400 in 8 of them");
}

}  // namespace
}  // namespace poinsot::compare
