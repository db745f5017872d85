// SPDX-License-Identifier: Apache-2.0
#include "figure/ink.h"

#include <gtest/gtest.h>

namespace poinsot::figure {
namespace {

// A viewer blends the ink over the paper in encoded values. The result must be the blend of light, encoded.
TEST(FigureInk, LooksOnThePaperLikeLinearBlending) {
  for (const std::uint32_t paper : {0xffffffu, 0x101418u, 0x808080u, 0x000000u})
    for (const std::uint32_t color : {0x000000u, 0xffffffu, 0xd55e00u, 0x0072b2u})
      for (const float opacity : {0.05f, 0.2f, 0.5f, 0.9f, 1.0f}) {
        const draw::Color under = draw::fromSrgb(paper), over = draw::fromSrgb(color);
        const Ink ink = inkOver(under, over, opacity);
        EXPECT_LE(ink.alpha, 1 + 1e-12);
        for (int c = 0; c < 3; ++c) {
          EXPECT_GE(ink.srgb[c], 0);
          EXPECT_LE(ink.srgb[c], 1);
          const double seen = (1 - ink.alpha) * draw::srgb8FromLinear(under[c]) + ink.alpha * 255 * ink.srgb[c];
          const int wanted = draw::srgb8FromLinear(opacity * over[c] + (1 - opacity) * under[c]);
          EXPECT_NEAR(seen, wanted, 1e-9) << std::hex << paper << ' ' << color << ' ' << opacity;
        }
      }
}

TEST(FigureInk, KeepsItsColourIfOpaque) {
  EXPECT_EQ(hexOf(inkOver(draw::Color(1), draw::fromSrgb(0xd55e00), 1)), "#d55e00");
  EXPECT_EQ(inkOver(draw::Color(0), draw::fromSrgb(0xd55e00), 1).alpha, 1);
}

}  // namespace
}  // namespace poinsot::figure
