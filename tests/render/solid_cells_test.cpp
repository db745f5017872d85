// SPDX-License-Identifier: Apache-2.0
// Cells of 16 pixels, which record where solids are, where they may cut each other, and where edges may be behind
// one another.
#include "render/solid_cells.h"

#include <gtest/gtest.h>

namespace poinsot::render {
namespace {

constexpr DepthRange kNear{1, 3}, kMiddle{2, 5}, kFar{4, 6};

PixelBounds cell(int column, int row) {
  const auto x = 16.0f * static_cast<float>(column), y = 16.0f * static_cast<float>(row);
  return {x, y, x + 16, y + 16};
}

SolidReach reachOf(const SolidCells& cells, int column, int row) { return cells.reach(cell(column, row))[1]; }

TEST(SolidCellsTest, ACellIsSharedOnlyByDifferentSolids) {
  SolidCells cells({100, 60});
  cells.nextSolid();
  cells.markSolid(PixelBounds{0, 0, 40, 20}, kNear);
  cells.markSolid(PixelBounds{0, 0, 40, 20}, kNear);
  EXPECT_FALSE(cells.anyShared());
  cells.nextSolid();
  cells.markSolid(PixelBounds{33, 17, 90, 50}, kMiddle);
  EXPECT_TRUE(cells.anyShared());
  EXPECT_TRUE(cells.shared(cell(2, 1)));
  EXPECT_FALSE(cells.shared(cell(1, 1)));
  EXPECT_FALSE(cells.shared(cell(3, 1)));
  const PixelBounds part = cells.sharedPart({0, 0, 100, 60});
  EXPECT_EQ(part.asVec4(), cell(2, 1).asVec4());
}

// A solid behind another has no seam with it, unless either of them reaches farther.
TEST(SolidCellsTest, ACellIsSharedOnlyIfDepthRangesOverlap) {
  SolidCells cells({100, 60});
  cells.nextSolid();
  cells.markSolid(cell(0, 0), kNear);
  cells.nextSolid();
  cells.markSolid(cell(0, 0), kFar);
  EXPECT_FALSE(cells.anyShared());
  cells.markSolid(cell(0, 0), kMiddle);
  EXPECT_TRUE(cells.shared(cell(0, 0)));

  cells = SolidCells({100, 60});
  const std::array depths{DepthRange{1, 2}, DepthRange{3, 4}, DepthRange{5, 6}, DepthRange{7, 8}};
  for (std::size_t i = 0; i < 3; ++i) {
    cells.nextSolid();
    cells.markSolid(cell(0, 0), depths[i]);
  }
  EXPECT_FALSE(cells.anyShared());
  cells.nextSolid();
  cells.markSolid(cell(0, 0), depths[3]);  // more depths than a cell keeps apart
  EXPECT_TRUE(cells.anyShared());
}

TEST(SolidCellsTest, ATriangleMarksOnlyTheCellsItCrosses) {
  SolidCells cells({160, 160});
  cells.nextSolid();
  cells.markSolid(PixelBounds{0, 0, 160, 160}, kNear);
  cells.nextSolid();
  cells.markSolid({glm::vec2(2, 2), glm::vec2(158, 155), glm::vec2(158, 158)}, kNear);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(cells.shared(cell(i, i))) << i;
  EXPECT_FALSE(cells.shared(cell(8, 1)));
  EXPECT_FALSE(cells.shared(cell(1, 8)));
}

TEST(SolidCellsTest, IgnoresShapesOutsideThePicture) {
  SolidCells cells({100, 60});
  for (int i = 0; i < 2; ++i) {
    cells.nextSolid();
    cells.markSolid(PixelBounds{-50, -50, -10, -10}, kNear);
    cells.markSolid({glm::vec2(200, 10), glm::vec2(300, 10), glm::vec2(250, 50)}, kNear);
    cells.markEdge({glm::vec2(200, 10), glm::vec2(300, 10), glm::vec2(250, 50)});
  }
  EXPECT_FALSE(cells.any());
  EXPECT_FALSE(cells.anyShared());
}

TEST(SolidCellsTest, GivesSolidsDistinctNumbersAboveThatOfLines) {
  SolidCells cells({100, 60});
  const float first = cells.nextSolid(), second = cells.nextSolid();
  EXPECT_NE(first, second);
  EXPECT_GT(first, SolidCells::noSolid());
  EXPECT_GT(SolidCells::noSolid(), 0);
}

// A solid has no edge inside. Two strands may be in one pixel, and so may an edge and a seam.
TEST(SolidCellsTest, TilesHaveAnInteriorOneEdgeOrTwoEdges) {
  SolidCells cells({160, 160});
  cells.nextSolid();
  cells.markSolid(PixelBounds{0, 0, 160, 90}, kNear);
  cells.markEdge(PixelBounds{0, 80, 160, 90});
  EXPECT_EQ(reachOf(cells, 3, 3), SolidReach::kInside);
  EXPECT_EQ(reachOf(cells, 3, 5), SolidReach::kOneEdge);
  EXPECT_EQ(reachOf(cells, 3, 6), SolidReach::kNone);
  cells.nextStrand();
  cells.markEdge({glm::vec2(2, 2), glm::vec2(14, 2), glm::vec2(2, 14)});
  EXPECT_EQ(reachOf(cells, 0, 0), SolidReach::kOneEdge);
  cells.markEdge(PixelBounds{2, 82, 14, 84});
  EXPECT_EQ(reachOf(cells, 0, 5), SolidReach::kTwoEdges);
  EXPECT_TRUE(cells.twoEdges({0, 70, 20, 90}));
  EXPECT_FALSE(cells.twoEdges({20, 0, 160, 160}));
  EXPECT_FALSE(cells.anyShared());

  cells.nextSolid();
  cells.markSolid(PixelBounds{66, 2, 70, 4}, kNear);
  EXPECT_EQ(reachOf(cells, 4, 0), SolidReach::kOneEdge) << "a seam";
  cells.markEdge(PixelBounds{66, 2, 70, 4});
  EXPECT_EQ(reachOf(cells, 4, 0), SolidReach::kTwoEdges);
  const auto range = cells.reach({0, 0, 160, 160});
  EXPECT_EQ(range[0], SolidReach::kNone);
  EXPECT_EQ(range[1], SolidReach::kTwoEdges);
}

TEST(SolidCellsTest, ThePartEnclosesAllMarkedCellsWithAMargin) {
  SolidCells cells({500, 300});
  EXPECT_TRUE(cells.part().empty());
  cells.nextSolid();
  cells.markSolid(PixelBounds{145, 100, 170, 110}, kNear);  // in columns 9 and 10 of row 6
  EXPECT_EQ(cells.part().asVec4(), glm::vec4(128, 64, 192, 128));
  cells.markEdge(PixelBounds{490, 128, 495, 140});
  EXPECT_EQ(cells.part().asVec4(), glm::vec4(128, 64, 500, 160)) << "no farther than the picture";
  cells.markEdge(PixelBounds{110, 100, 111, 101});
  EXPECT_EQ(cells.part().asVec4(), glm::vec4(64, 64, 500, 160));
  cells.markEdge(PixelBounds{3, 3, 5, 5});
  EXPECT_EQ(cells.part().asVec4(), glm::vec4(0, 0, 500, 160));
}

}  // namespace
}  // namespace poinsot::render
