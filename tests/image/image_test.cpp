// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <gtest/gtest.h>

namespace poinsot::image {
namespace {

TEST(Image, StartsWithZerosInRowOrder) {
  Image picture({3, 2}, 4);
  EXPECT_EQ(picture.pixels, std::vector<std::uint8_t>(24, 0));
  EXPECT_EQ(picture.rowBytes(), 12u);
  picture.at(2, 1)[3] = 7;  // last channel of the last pixel is the last byte
  EXPECT_EQ(picture.pixels.back(), 7);
  EXPECT_EQ(picture.at(0, 1) - picture.at(0, 0), 12);
}

TEST(Image, RejectsImpossibleShapes) {
  EXPECT_THROW(Image({0, 2}, 3), std::logic_error);
  EXPECT_THROW(Image({2, -1}, 3), std::logic_error);
  EXPECT_THROW(Image({2, 2}, 2), std::logic_error);
  EXPECT_NO_THROW(Image({1, 1}, 3));
}

}  // namespace
}  // namespace poinsot::image
