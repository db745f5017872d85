// SPDX-License-Identifier: Apache-2.0
// Cuts a picture into rectangles of equal content, and compares them with the content of each single pixel. The
// sizes are not multiples of the sizes of tiles and cells.
#include "render/mosaic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "glass_over_plane.h"

namespace poinsot::render {
namespace {

constexpr int kWidth = 330, kHeight = 210;

draw::DrawList ellipsoidOverPlane() { return glassOverPlane({kWidth, kHeight}, 0.6f); }

SolidCells someSolids() {
  SolidCells cells(glm::vec2(kWidth, kHeight));
  cells.nextSolid();
  cells.markSolid(PixelBounds{130, 70, 215, 120}, {1, 2});
  cells.markEdge(PixelBounds{130, 70, 215, 74});
  cells.nextStrand();
  cells.markEdge(PixelBounds{200, 60, 205, 200});
  return cells;
}

/// Content of each pixel, and the number of rectangles that cover the pixel.
struct Unfolded {
  std::vector<int> times = std::vector<int>(kWidth * kHeight);
  std::vector<const Content*> contents = std::vector<const Content*>(kWidth * kHeight);

  explicit Unfolded(const Mosaic& mosaic) {
    for (const auto& [content, parts] : mosaic.parts)
      for (const PixelBounds& part : parts)
        for (int y = static_cast<int>(part.top); y < static_cast<int>(part.bottom); ++y)
          for (int x = static_cast<int>(part.left); x < static_cast<int>(part.right); ++x) {
            ++times.at(static_cast<std::size_t>(y * kWidth + x));
            contents.at(static_cast<std::size_t>(y * kWidth + x)) = &content;
          }
  }
};

template <typename Use>
void forEachPixel(Use use) {
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) use(x, y, static_cast<std::size_t>(y * kWidth + x));
}

TileCache blankMemory() {
  TileCache tiles;
  tiles.beginPicture({kWidth, kHeight}, {});
  return tiles;
}

/// Returns how many of the rectangles cover each pixel.
std::vector<int> timesIn(const std::vector<PixelBounds>& rectangles) {
  Mosaic one;
  one.parts[{}] = rectangles;
  return Unfolded(one).times;
}

TEST(Mosaic, CoversEachPixelOnce) {
  const draw::DrawList list = ellipsoidOverPlane();
  TileCache tiles = blankMemory();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, Sheets(list), someSolids(), tiles);
  const Unfolded all(mosaic);
  EXPECT_EQ(timesIn(mosaic.drawn), all.times);
  const auto paper = timesIn(mosaic.paper);
  int blank = 0;
  forEachPixel([&](int x, int y, std::size_t i) {
    EXPECT_EQ(all.times[i] + paper[i], 1) << x << ", " << y;
    blank += paper[i];
  });
  EXPECT_GT(blank, 1000);
}

// Each pixel's rectangle draws all that the pixel's own square may show. Where no outline is drawn, each sheet
// fills the pixel.
TEST(Mosaic, DrawsEverySolidAndSheetThatAPixelShows) {
  const draw::DrawList list = ellipsoidOverPlane();
  const Sheets sheets(list);
  const SolidCells solids = someSolids();
  TileCache tiles = blankMemory();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, sheets, solids, tiles);
  const Unfolded all(mosaic);
  int withOutlines = 0, filled = 0;
  forEachPixel([&](int x, int y, std::size_t i) {
    const PixelBounds pixel{static_cast<float>(x), static_cast<float>(y), static_cast<float>(x + 1),
                            static_cast<float>(y + 1)};
    const Content own{solids.reach(pixel)[1], sheets.reaching(pixel)};
    if (own.empty()) return;
    ASSERT_NE(all.contents[i], nullptr) << x << ", " << y;
    const Content& drawn = *all.contents[i];
    EXPECT_GE(drawn.solids, own.solids) << x << ", " << y;
    EXPECT_TRUE(std::ranges::includes(drawn.sheets.ellipsoids, own.sheets.ellipsoids)) << x << ", " << y;
    EXPECT_TRUE(std::ranges::includes(drawn.sheets.planes, own.sheets.planes)) << x << ", " << y;
    if (drawn.sheets.outlines) return void(++withOutlines);
    ++filled;
    EXPECT_EQ(drawn.sheets, own.sheets) << x << ", " << y;
  });
  EXPECT_GT(withOutlines, 1000);
  EXPECT_GT(filled, 1000);
}

TEST(Mosaic, HasOnlyBackgroundTilesForAnEmptyPicture) {
  draw::DrawList list = ellipsoidOverPlane();
  list.glassEllipsoids.clear();
  list.planes.clear();
  TileCache tiles = blankMemory();
  const Mosaic mosaic = cutIntoMosaic(list.camera.size_px, Sheets(list), SolidCells(list.camera.size_px), tiles);
  EXPECT_TRUE(mosaic.parts.empty());
  EXPECT_TRUE(mosaic.drawn.empty());
  const auto times = timesIn(mosaic.paper);
  EXPECT_EQ(std::ranges::count(times, 1), kWidth * kHeight);
}

// A second picture consists only of tiles with solids, tiles of a sheet that changed, and tiles that were painted
// over.
class SecondMosaic : public testing::Test {
 protected:
  SecondMosaic() { cut(list_); }

  Mosaic cut(const draw::DrawList& list, const Constants& common = {}) {
    tiles_.beginPicture({kWidth, kHeight}, common);
    Mosaic mosaic = cutIntoMosaic(list.camera.size_px, Sheets(list), solids_, tiles_);
    tiles_.endPicture();
    return mosaic;
  }

  bool covers(const std::vector<PixelBounds>& rectangles, int x, int y) const {
    return timesIn(rectangles)[static_cast<std::size_t>(y * kWidth + x)] == 1;
  }

  draw::DrawList list_ = ellipsoidOverPlane();
  SolidCells solids_ = someSolids();
  TileCache tiles_;
};

TEST_F(SecondMosaic, RedrawsOnlyTilesWithSolidsIfNothingChanged) {
  const Mosaic mosaic = cut(list_);
  EXPECT_TRUE(mosaic.paper.empty());
  const auto drawn = timesIn(mosaic.drawn);
  forEachPixel([&](int x, int y, std::size_t i) {
    constexpr int side = kTile_px;
    const PixelBounds tile{static_cast<float>(x / side * side), static_cast<float>(y / side * side),
                           static_cast<float>((x / side + 1) * side), static_cast<float>((y / side + 1) * side)};
    EXPECT_EQ(drawn[i] == 1, solids_.reach(tile)[1] != SolidReach::kNone) << x << ", " << y;
  });
}

TEST_F(SecondMosaic, RedrawsTilesOfAnEllipsoidThatTurned) {
  list_.glassEllipsoids[0].semiAxes_V[0] *= 1.001f;
  const Mosaic mosaic = cut(list_);
  const glm::ivec2 centre(kWidth / 2, kHeight / 2);
  EXPECT_TRUE(covers(mosaic.drawn, centre.x, centre.y));
  EXPECT_FALSE(covers(mosaic.drawn, 2, centre.y));
}

TEST_F(SecondMosaic, RedrawsTilesThatWereOverwritten) {
  tiles_.forget({-20, 2, 3, 5});
  const Mosaic mosaic = cut(list_);
  EXPECT_EQ(mosaic.paper.size(), 1u);
  EXPECT_TRUE(covers(mosaic.paper, 63, 63));
  EXPECT_FALSE(covers(mosaic.paper, 64, 63));
}

TEST_F(SecondMosaic, RedrawsAllTilesIfTheLightChanges) {
  const Mosaic mosaic = cut(list_, {glm::vec4(1)});
  EXPECT_TRUE(covers(mosaic.paper, 0, 0));
  EXPECT_TRUE(covers(mosaic.drawn, kWidth / 2, kHeight - 20));
}

TEST_F(SecondMosaic, RedrawsAllTilesAfterAnUnfinishedPicture) {
  tiles_.beginPicture({kWidth, kHeight}, {});
  EXPECT_TRUE(covers(cut(list_).paper, 0, 0));
}

}  // namespace
}  // namespace poinsot::render
