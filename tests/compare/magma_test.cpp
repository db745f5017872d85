// SPDX-License-Identifier: Apache-2.0
#include "compare/magma.h"

#include <gtest/gtest.h>

namespace poinsot::compare {
namespace {

// The ends and the middle of the map are as in matplotlib's documentation: #000004, #b73779, #fcfdbf.
TEST(Magma, HasTheDocumentedColours) {
  const image::Image picture = magmaPicture({{5, 1}, {0, 128.0 / 255, 1, 0.5 / 255, 2}});
  const std::vector<std::uint8_t> expected{0x00, 0x00, 0x04, 0xb7, 0x37, 0x79, 0xfc, 0xfd,
                                           0xbf, 0x01, 0x00, 0x05, 0xfc, 0xfd, 0xbf};
  EXPECT_EQ(picture.pixels, expected);
}

TEST(Magma, GrowsLighter) {
  FlipMap map{{256, 1}, {}};
  for (int i = 0; i < 256; ++i) map.error.push_back(i / 255.0);
  const image::Image picture = magmaPicture(map);
  const auto luma = [&](int x) {
    const std::uint8_t* p = picture.at(x, 0);
    return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
  };
  for (int x = 4; x < 256; ++x) EXPECT_GT(luma(x), luma(x - 4)) << x;
}

}  // namespace
}  // namespace poinsot::compare
