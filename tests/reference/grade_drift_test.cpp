// SPDX-License-Identifier: Apache-2.0
// findDrift() on made-up errors whose start and growth are known.
#include "reference/grade_drift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace poinsot::reference {
namespace {

struct Series {
  std::vector<double> t_s, errors;
};

Series series(int rows, double step_s, const std::function<double(double)>& error) {
  Series s;
  for (int k = 0; k < rows; ++k) {
    s.t_s.push_back(k * step_s);
    s.errors.push_back(error(std::abs(k * step_s)));
  }
  return s;
}

Drift driftOf(int rows, double step_s, const std::function<double(double)>& error) {
  const Series s = series(rows, step_s, error);
  return findDrift(s.t_s, s.errors);
}

/// Returns noise between 0 and `size`, as of an engine that rounds its output, from a fixed seed.
std::function<double()> noise(double size) {
  return [size, bits = std::mt19937(7)]() mutable { return size * static_cast<double>(bits()) * 0x1p-32; };
}

TEST(Drift, IsOnlyRoundingForACopy) {
  const auto rounding = noise(1e-15);
  EXPECT_EQ(driftOf(1000, 0.01, [&](double) { return rounding(); }).kind, DriftKind::kRounding);
  EXPECT_EQ(driftOf(2, 1, [](double) { return 0; }).kind, DriftKind::kRounding);
}

TEST(Drift, IsAConstantErrorLevelForRoundedOutput) {
  const auto printed = noise(1e-6);
  EXPECT_EQ(driftOf(1000, 0.01, [&](double) { return printed(); }).kind, DriftKind::kLevel);
}

TEST(Drift, IsAConstantErrorLevelForABoundedOscillation) {
  EXPECT_EQ(driftOf(1000, 0.1, [](double t) { return 1e-4 * std::abs(std::sin(1.7 * t)); }).kind,
            DriftKind::kLevel);
}

class DriftOfOrder : public testing::TestWithParam<int> {};

TEST_P(DriftOfOrder, IsFoundFromTheStart) {
  const Drift drift = driftOf(1001, 0.01, [](double t) { return 1e-4 * std::pow(t, GetParam()); });
  EXPECT_EQ(drift.kind, DriftKind::kDrift);
  EXPECT_EQ(drift.from_s, 0);
  EXPECT_EQ(drift.growth, Growth::kPower);
  EXPECT_NEAR(drift.order, GetParam(), 1e-6);
}

TEST_P(DriftOfOrder, StartTimeIsFoundToWithinOneRow) {
  for (const double start_s : {1.0, 5.0, 9.0}) {
    const auto error = [&](double t) { return t > start_s ? 1e-4 * std::pow(t - start_s, GetParam()) : 1e-16; };
    const Drift drift = driftOf(1001, 0.01, error);
    EXPECT_EQ(drift.kind, DriftKind::kDrift);
    EXPECT_NEAR(drift.from_s, start_s, 0.0101);
    EXPECT_EQ(drift.growth, Growth::kPower);
    EXPECT_NEAR(drift.order, GetParam(), 0.1);
  }
}

TEST_P(DriftOfOrder, IsFoundAboveRoundedOutput) {
  const auto printed = noise(1e-6);
  const auto error = [&](double t) { return printed() + (t > 5 ? 1e-3 * std::pow(t - 5, GetParam()) : 0); };
  const Drift drift = driftOf(1001, 0.01, error);
  EXPECT_EQ(drift.kind, DriftKind::kDrift);
  // The drift shows when it exceeds the noise, at 1e-3 (t - 5)^p = 1e-6 to 2e-6.
  EXPECT_GE(drift.from_s, 4.99);
  EXPECT_LE(drift.from_s, 5 + std::pow(2e-3, 1.0 / GetParam()) + 0.02);
}

TEST_P(DriftOfOrder, IsFoundBackwardsInTime) {
  const Drift drift =
      driftOf(1001, -0.01, [](double t) { return t > 5 ? 1e-4 * std::pow(t - 5, GetParam()) : 0; });
  EXPECT_NEAR(drift.from_s, -5, 0.0101);
  EXPECT_NEAR(drift.order, GetParam(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Grade, DriftOfOrder, testing::Values(1, 2, 3));

TEST(Drift, StartsAtASuddenStep) {
  const Drift drift = driftOf(1001, 0.01, [](double t) { return t > 5 ? 1e-3 : 1e-16; });
  EXPECT_EQ(drift.kind, DriftKind::kDrift);
  EXPECT_EQ(drift.from_s, 5);
  EXPECT_EQ(drift.growth, Growth::kPower);
  EXPECT_NEAR(drift.order, 0, 1e-9);
}

TEST(Drift, HasTheRateOfExponentialGrowth) {
  const Drift drift = driftOf(1001, 0.02, [](double t) { return 1e-9 * std::exp(0.7 * t); });
  EXPECT_EQ(drift.kind, DriftKind::kDrift);
  EXPECT_EQ(drift.growth, Growth::kExponential);
  EXPECT_NEAR(drift.rate, 0.7, 1e-6);
}

TEST(Drift, HasTheGrowthBeforeErrorsLevelOff) {
  const Drift drift = driftOf(1001, 0.1, [](double t) { return std::min(3.0, t > 20 ? 0.05 * (t - 20) : 1e-16); });
  EXPECT_NEAR(drift.from_s, 20, 0.11);
  EXPECT_NEAR(drift.order, 1, 0.1);
}

TEST(Drift, StartsBeforeASuddenLargeError) {
  const auto error = [](double t) { return t > 5 ? INFINITY : 1e-6; };
  EXPECT_EQ(driftOf(1001, 0.01, error).from_s, 5);
  const Drift soon = driftOf(10, 1, [](double t) { return t > 2 ? 1.0 : 0.0; });
  EXPECT_EQ(soon.kind, DriftKind::kDrift);
  EXPECT_EQ(soon.from_s, 2);
}

TEST(Drift, IsUnknownForTooFewRows) {
  EXPECT_EQ(driftOf(10, 1, [](double t) { return 1e-3 * t; }).kind, DriftKind::kTooFewRows);
}

TEST(Drift, RejectsMoreTimesThanErrors) {
  const std::vector<double> t_s{0, 1}, errors{0};
  EXPECT_THROW(findDrift(t_s, errors), std::logic_error);
}

}  // namespace
}  // namespace poinsot::reference
