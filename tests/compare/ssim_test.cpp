// SPDX-License-Identifier: Apache-2.0
#include "compare/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/noise.h"

namespace poinsot::compare {
namespace {

image::Image flat(image::PixelSize size, std::uint8_t value) {
  image::Image picture(size, 3);
  picture.pixels.assign(picture.pixels.size(), value);
  return picture;
}

/// Returns the SSIM of one window, straight from the definition: weights over two dimensions, central moments.
double windowAt(const image::Image& a, const image::Image& b, int cx, int cy) {
  const auto luma = [](const std::uint8_t* p) { return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]; };
  const auto sum = [&](auto f) {
    double total = 0, weights = 0;
    for (int j = -5; j <= 5; ++j)
      for (int i = -5; i <= 5; ++i) {
        const double w = std::exp(-(i * i + j * j) / 4.5);
        total += w * f(luma(a.at(cx + i, cy + j)), luma(b.at(cx + i, cy + j)));
        weights += w;
      }
    return total / weights;
  };
  const double ma = sum([](double p, double) { return p; }), mb = sum([](double, double q) { return q; });
  const double va = sum([&](double p, double) { return (p - ma) * (p - ma); });
  const double vb = sum([&](double, double q) { return (q - mb) * (q - mb); });
  const double cov = sum([&](double p, double q) { return (p - ma) * (q - mb); });
  constexpr double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
  return (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

TEST(Ssim, IsOneForEqualPictures) {
  const auto figures = ssim(image::noise({20, 15}, 1), image::noise({20, 15}, 1));
  EXPECT_EQ(figures->mean, 1);
  EXPECT_EQ(figures->worst, 1);
}

// Flat pictures have no variance, so that SSIM is (2 ab + C1) / (a² + b² + C1) with C1 = 2.55².
TEST(Ssim, MatchesTheFormulaForFlatPictures) {
  const auto figures = ssim(flat({11, 11}, 100), flat({11, 11}, 120));
  const double c1 = 2.55 * 2.55;
  EXPECT_NEAR(figures->mean, (2 * 100 * 120 + c1) / (100 * 100 + 120 * 120 + c1), 1e-12);
}

// 14x13 pixels have 4x3 windows; each window is computed by the definition. Measured 3e-15.
TEST(Ssim, IsTheMeanOfItsWindows) {
  const image::Image a = image::noise({14, 13}, 2), b = image::noise({14, 13}, 3);
  double sum = 0, worst = 2;
  int worstX = 0, worstY = 0;
  for (int y = 5; y < 8; ++y)
    for (int x = 5; x < 9; ++x) {
      const double s = windowAt(a, b, x, y);
      sum += s;
      if (s >= worst) continue;
      worst = s;
      worstX = x;
      worstY = y;
    }
  const auto figures = ssim(a, b);
  EXPECT_NEAR(figures->mean, sum / 12, 1e-12);
  EXPECT_NEAR(figures->worst, worst, 1e-12);
  EXPECT_EQ(figures->worstX, worstX);
  EXPECT_EQ(figures->worstY, worstY);
}

TEST(Ssim, IsAbsentForPicturesSmallerThanAWindow) {
  EXPECT_FALSE(ssim(flat({10, 11}, 1), flat({10, 11}, 2)));
  EXPECT_FALSE(ssim(flat({1, 1}, 1), flat({1, 1}, 2)));
  EXPECT_TRUE(ssim(flat({11, 11}, 1), flat({11, 11}, 2)));
}

}  // namespace
}  // namespace poinsot::compare
