// SPDX-License-Identifier: Apache-2.0
// Where solids are, and where they may cut each other: cells 16 pixels wide that two of them touch.
#include "render/solid_cells.h"

#include <gtest/gtest.h>

namespace poinsot::render {
namespace {

PixelBounds cell(int column, int row) {
  const auto x = 16.0f * static_cast<float>(column), y = 16.0f * static_cast<float>(row);
  return {x, y, x + 16, y + 16};
}

TEST(SolidCellsTest, ACellIsSharedByTwoSolidsNotByOneTwice) {
  SolidCells cells({100, 60});
  cells.nextSolid();
  cells.mark(PixelBounds{0, 0, 40, 20}, SolidReach::kInside);
  cells.mark(PixelBounds{0, 0, 40, 20}, SolidReach::kInside);
  EXPECT_FALSE(cells.anyShared());
  cells.nextSolid();
  cells.mark(PixelBounds{33, 17, 90, 50}, SolidReach::kInside);
  EXPECT_TRUE(cells.anyShared());
  EXPECT_TRUE(cells.shared(cell(2, 1)));
  EXPECT_FALSE(cells.shared(cell(1, 1)));
  EXPECT_FALSE(cells.shared(cell(3, 1)));
  const PixelBounds part = cells.sharedPart({0, 0, 100, 60});
  EXPECT_EQ(part.asVec4(), cell(2, 1).asVec4());
}

// Along a diagonal the cells beside it stay free.
TEST(SolidCellsTest, ATriangleTouchesWhatItCrossesOnly) {
  SolidCells cells({160, 160});
  cells.nextSolid();
  cells.mark(PixelBounds{0, 0, 160, 160}, SolidReach::kInside);
  cells.nextSolid();
  cells.mark({glm::vec2(2, 2), glm::vec2(158, 155), glm::vec2(158, 158)}, SolidReach::kInside);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(cells.shared(cell(i, i))) << i;
  EXPECT_FALSE(cells.shared(cell(8, 1)));
  EXPECT_FALSE(cells.shared(cell(1, 8)));
}

TEST(SolidCellsTest, WhatIsOutsideThePictureIsNotMarked) {
  SolidCells cells({100, 60});
  for (int i = 0; i < 2; ++i) {
    cells.nextSolid();
    cells.mark(PixelBounds{-50, -50, -10, -10}, SolidReach::kInside);
    cells.mark({glm::vec2(200, 10), glm::vec2(300, 10), glm::vec2(250, 50)}, SolidReach::kInside);
  }
  EXPECT_FALSE(cells.anyShared());
}

TEST(SolidCellsTest, NumbersDifferAndAreNotThatOfALine) {
  SolidCells cells({100, 60});
  const float first = cells.nextSolid(), second = cells.nextSolid();
  EXPECT_NE(first, second);
  EXPECT_GT(first, SolidCells::noSolid());
  EXPECT_GT(SolidCells::noSolid(), 0);
}

// Inside a solid there is no edge; where it ends, where another one joins it and where a line runs there may be.
TEST(SolidCellsTest, TellInsidesFromEdges) {
  SolidCells cells({160, 160});
  EXPECT_FALSE(cells.any());
  const auto at = [&](int column, int row) { return cells.reach(cell(column, row))[1]; };
  cells.nextSolid();
  cells.mark(PixelBounds{0, 0, 160, 80}, SolidReach::kInside);
  cells.mark(PixelBounds{0, 80, 160, 90}, SolidReach::kEdges);
  EXPECT_TRUE(cells.any());
  EXPECT_EQ(at(3, 3), SolidReach::kInside);
  EXPECT_EQ(at(3, 5), SolidReach::kEdges);
  EXPECT_EQ(at(3, 6), SolidReach::kNone);
  cells.markFlat({glm::vec2(2, 2), glm::vec2(14, 2), glm::vec2(2, 14)});
  EXPECT_EQ(at(0, 0), SolidReach::kEdges);
  EXPECT_FALSE(cells.anyShared());
  cells.markEdge({25, 5});
  EXPECT_EQ(at(1, 0), SolidReach::kEdges);
  EXPECT_EQ(at(2, 0), SolidReach::kInside);
  cells.nextSolid();
  cells.mark(PixelBounds{66, 2, 70, 4}, SolidReach::kInside);
  EXPECT_EQ(at(4, 0), SolidReach::kEdges);
  const auto range = cells.reach({0, 0, 160, 160});
  EXPECT_EQ(range[0], SolidReach::kNone);
  EXPECT_EQ(range[1], SolidReach::kEdges);
}

}  // namespace
}  // namespace poinsot::render
