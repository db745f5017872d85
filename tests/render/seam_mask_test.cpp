// SPDX-License-Identifier: Apache-2.0
// Where solids may cut each other: cells 16 pixels wide that two of them touch.
#include "render/seam_mask.h"

#include <gtest/gtest.h>

namespace poinsot::render {
namespace {

PixelBounds cell(int column, int row) {
  const auto x = 16.0f * static_cast<float>(column), y = 16.0f * static_cast<float>(row);
  return {x, y, x + 16, y + 16};
}

TEST(SeamMaskTest, ACellIsSharedByTwoSolidsNotByOneTwice) {
  SeamMask mask({100, 60});
  mask.nextSolid();
  mask.mark(PixelBounds{0, 0, 40, 20});
  mask.mark(PixelBounds{0, 0, 40, 20});
  EXPECT_FALSE(mask.any());
  mask.nextSolid();
  mask.mark(PixelBounds{33, 17, 90, 50});
  EXPECT_TRUE(mask.any());
  EXPECT_TRUE(mask.shared(cell(2, 1)));
  EXPECT_FALSE(mask.shared(cell(1, 1)));
  EXPECT_FALSE(mask.shared(cell(3, 1)));
  const PixelBounds part = mask.sharedPart({0, 0, 100, 60});
  EXPECT_EQ(part.asVec4(), cell(2, 1).asVec4());
}

// Along a diagonal the cells beside it stay free.
TEST(SeamMaskTest, ATriangleTouchesWhatItCrossesOnly) {
  SeamMask mask({160, 160});
  mask.nextSolid();
  mask.mark(PixelBounds{0, 0, 160, 160});
  mask.nextSolid();
  mask.mark({glm::vec2(2, 2), glm::vec2(158, 155), glm::vec2(158, 158)});
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(mask.shared(cell(i, i))) << i;
  EXPECT_FALSE(mask.shared(cell(8, 1)));
  EXPECT_FALSE(mask.shared(cell(1, 8)));
}

TEST(SeamMaskTest, WhatIsOutsideThePictureIsNotMarked) {
  SeamMask mask({100, 60});
  for (int i = 0; i < 2; ++i) {
    mask.nextSolid();
    mask.mark(PixelBounds{-50, -50, -10, -10});
    mask.mark({glm::vec2(200, 10), glm::vec2(300, 10), glm::vec2(250, 50)});
  }
  EXPECT_FALSE(mask.any());
}

TEST(SeamMaskTest, NumbersDifferAndAreNotThatOfALine) {
  SeamMask mask({100, 60});
  const float first = mask.nextSolid(), second = mask.nextSolid();
  EXPECT_NE(first, second);
  EXPECT_GT(first, SeamMask::noSolid());
  EXPECT_GT(SeamMask::noSolid(), 0);
}

}  // namespace
}  // namespace poinsot::render
