// SPDX-License-Identifier: Apache-2.0
// Checks each stage of FLIP against values that are worked out by hand, or published by others.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/flip.h"
#include "compare/flip_color.h"
#include "compare/flip_stages.h"

namespace poinsot::compare {
namespace {

void expectNear(const Triple& actual, const Triple& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

// IEC 61966-2-1: the straight piece ends at 0.04045, and 128/255 is 0.2158605 in the tables.
TEST(FlipColor, SrgbIsDecoded) {
  EXPECT_EQ(linearLight(0), 0);
  EXPECT_EQ(linearLight(1), 1);
  EXPECT_DOUBLE_EQ(linearLight(0.04), 0.04 / 12.92);
  EXPECT_NEAR(linearLight(128 / 255.0), 0.2158605, 5e-8);
}

// X, Y, Z of green are the second column of the matrix. Divided by white, they are 8788810/23359437,
// 8788810/12288897 and 8788810/80288307. Then Y = 116 y - 16, Cx = 500 (x - y), Cz = 200 (y - z) by hand.
TEST(FlipColor, ConvertsToOpponentSpace) {
  expectNear(opponentColor({0, 0, 0}), {-16, 0, 0}, 1e-13);
  expectNear(opponentColor({1, 1, 1}), {100, 0, 0}, 1e-12);
  const double x = 8788810.0 / 23359437, y = 8788810.0 / 12288897, z = 8788810.0 / 80288307;
  expectNear(opponentColor({0, 1, 0}), {116 * y - 16, 500 * (x - y), 200 * (y - z)}, 1e-12);
  expectNear(opponentColor({0, 1, 0}), {66.9604, -169.4698, 121.1435}, 1e-2);  // the same, on a pocket calculator
}

TEST(FlipColor, ConvertsToOpponentSpaceAndBack) {
  for (const Triple& rgb : {Triple{0.1, 0.7, 0.3}, {1, 0, 0}, {0, 0.02, 1}})
    expectNear(rgbOfOpponent(opponentColor(rgb)), rgb, 1e-14);
  expectNear(rgbOfOpponent({200, 0, 0}), {1, 1, 1}, 0);  // clamped
  expectNear(rgbOfOpponent({-40, 0, 0}), {0, 0, 0}, 0);
}

// Without the Hunt effect, colour tables give red, green and blue of sRGB as (53.24, 80.09, 67.20), (87.73,
// -86.18, 83.18) and (32.30, 79.19, -107.86) in CIELab of D65. With the effect, a and b are multiplied by L/100.
TEST(FlipColor, ScalesChromaWithLightness) {
  expectNear(huntLab({1, 0, 0}), {53.24, 0.5324 * 80.09, 0.5324 * 67.20}, 0.02);
  expectNear(huntLab({0, 1, 0}), {87.73, 0.8773 * -86.18, 0.8773 * 83.18}, 0.02);
  expectNear(huntLab({0, 0, 1}), {32.30, 0.3230 * 79.19, 0.3230 * -107.86}, 0.02);
  // Below (6/29)³ CIELab is straight: L = 903.3 Y.
  EXPECT_NEAR(huntLab({0.001, 0.001, 0.001})[0], 0.9033, 1e-4);
}

// |ΔL| = 1, and the chroma differs by the long side of a triangle of 3, 4, 5.
TEST(FlipColor, HyabAddsLightnessAndChroma) { EXPECT_EQ(hyabDistance({10, 3, -1}, {11, 6, 3}), 6); }

// Checks the authors' constant, both ends of the curve, and its knee: at 0.4 of the largest distance the error is
// 0.95.
TEST(FlipColor, MapsTheErrorByTheDefinedCurve) {
  EXPECT_NEAR(largestColorDistance(), 41.276098, 5e-7);
  EXPECT_EQ(colorError({50, 1, 2}, {50, 1, 2}, largestColorDistance()), 0);
  const auto errorAt = [](double distance) { return colorError({0, 0, 0}, {distance, 0, 0}, largestColorDistance()); };
  const double knee = std::pow(0.4 * 41.276098, 1 / 0.7);
  EXPECT_NEAR(errorAt(knee), 0.95, 1e-8);
  EXPECT_NEAR(errorAt(knee * std::pow(0.5, 1 / 0.7)), 0.475, 1e-8);
  EXPECT_NEAR(errorAt(std::pow(41.276098, 1 / 0.7)), 1, 1e-8);
  EXPECT_NEAR(errorAt(std::pow(0.7 * 41.276098, 1 / 0.7)), 0.975, 1e-8);
}

// The radius is ceil(3 √(0.04/(2π²)) 67.02) = ceil(9.05) = 10 for all three channels. A weight one pixel off is
// exp(-π²/(b p²)) of the middle weight: 0.626565 for b = 0.0047 at p = 67.02 pixels per degree. The weights sum to
// 1 over two dimensions.
TEST(FlipFilters, ContrastSensitivityHasTheDefinedWeights) {
  const auto channels = contrastSensitivity(kFlipPixelsPerDegree);
  for (const auto& parts : channels) {
    double total = 0;
    for (const SensitivityPart& part : parts) {
      EXPECT_EQ(part.profile.radius(), 10);
      total += part.weight * part.profile.sum() * part.profile.sum();
    }
    EXPECT_NEAR(total, 1, 1e-15);
  }
  const Kernel& y = channels[0][0].profile;
  EXPECT_NEAR(y.at(1) / y.at(0), 0.626565, 1e-6);
  // The two parts of Cz have the strengths 34.1 √(π/0.04) and 13.5 √(π/0.025), 302.2 and 151.3.
  EXPECT_NEAR(channels[2][0].weight / channels[2][1].weight, 34.1 * std::sqrt(0.025) / (13.5 * std::sqrt(0.04)),
              1e-13);
}

// The standard deviation is s = 0.5 · 0.082 · 67.02 = 2.7478, and the radius is ceil(8.24) = 9.
TEST(FlipFilters, FeatureKernelsHaveTheDefinedWeights) {
  const FeatureKernels kernels = featureKernels(kFlipPixelsPerDegree);
  EXPECT_EQ(kernels.smooth.radius(), 9);
  EXPECT_NEAR(kernels.smooth.sum(), 1, 1e-15);
  EXPECT_NEAR(kernels.smooth.at(3) / kernels.smooth.at(0), std::exp(-4.5 / (2.74785 * 2.74785)), 1e-5);
  for (const Kernel* kernel : {&kernels.edge, &kernels.point}) {
    double positive = 0, negative = 0;
    for (int i = -9; i <= 9; ++i) (kernel->at(i) > 0 ? positive : negative) += kernel->at(i);
    EXPECT_NEAR(positive, 1, 1e-15);
    EXPECT_NEAR(negative, -1, 1e-15);
  }
  EXPECT_GT(kernels.edge.at(-2), 0);
  EXPECT_EQ(kernels.edge.at(-2), -kernels.edge.at(2));
  EXPECT_LT(kernels.point.at(0), 0);  // q changes sign at s
  EXPECT_LT(kernels.point.at(2), 0);
  EXPECT_GT(kernels.point.at(3), 0);
}

// At a step from black to white, all negative weights are on one side, so that the two pixels beside the step have
// an edge of 1.
TEST(FlipFilters, AStepFromBlackToWhiteHasAnEdgeOfOne) {
  const FeatureKernels kernels = featureKernels(kFlipPixelsPerDegree);
  MarginedRow row(40, kernels.edge.radius());
  std::vector<double> out(40);
  std::fill(row.columns() + 20, row.columns() + 40 + kernels.edge.radius(), 1.0);
  kernels.edge.alongRow(row.columns(), {0, 40}, out.data());
  EXPECT_NEAR(std::abs(out[19]), 1, 1e-15);
  EXPECT_NEAR(std::abs(out[20]), 1, 1e-15);
  EXPECT_EQ(out[5], 0);
}

// In step 10 of A3, a black-white edge against nothing has the feature 1 and gives E = Ec^(1 - (1/√2)^½). The
// map's own colour error would not be an independent expectation. The test therefore checks the order alone: the
// edge makes the pixel's error larger than its colour does.
TEST(FlipFilters, AnEdgeRaisesTheError) {
  image::Image grey({64, 64}, 3), step({64, 64}, 3);
  grey.pixels.assign(grey.pixels.size(), 128);
  step.pixels.assign(step.pixels.size(), 128);
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x) std::fill_n(step.at(x, y), 3, std::uint8_t{160});
  const FlipMap map = flip(grey, step);
  EXPECT_GT(map.error[32 * 64 + 32], map.error[32 * 64 + 55]);
}

// Worked out by hand: the values 0.1, 0.2, 0.3, 0.4 sum to 1. The running sum 0.1, 0.3, 0.6, 1 exceeds a quarter
// at 0.2, a half at 0.3, and three quarters at 0.4. Quartiles by count would be others.
TEST(FlipFigures, AreWeightedByTheError) {
  const FlipFigures figures = figuresOf({{4, 1}, {0.4, 0.1, 0.3, 0.2}});
  EXPECT_DOUBLE_EQ(figures.mean, 0.25);
  EXPECT_EQ(figures.min, 0.1);
  EXPECT_EQ(figures.firstQuartile, 0.2);
  EXPECT_EQ(figures.median, 0.3);
  EXPECT_EQ(figures.thirdQuartile, 0.4);
  EXPECT_EQ(figures.max, 0.4);
  EXPECT_EQ(figuresOf({{2, 1}, {0, 0}}).median, 0);
}

}  // namespace
}  // namespace poinsot::compare
