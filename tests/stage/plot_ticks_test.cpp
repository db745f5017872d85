// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "stage/type/written_number.h"

namespace poinsot::stage {
namespace {

std::vector<std::string> labels(const Ticks& ticks) {
  std::vector<std::string> all;
  for (auto i = ticks.first; i <= ticks.last; ++i) all.push_back(tickDigits(ticks, i));
  return all;
}

TEST(PlotTicks, AreAtRoundNumbers) {
  EXPECT_EQ(labels(coveringTicks(-0.9, 1.4, 7)),
            (std::vector<std::string>{"-1.0", "-0.5", "0.0", "0.5", "1.0", "1.5"}));
  EXPECT_EQ(labels(coveringTicks(0, 18, 7)), (std::vector<std::string>{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(labels(innerTicks(0, 18.4, 7)), (std::vector<std::string>{"0", "5", "10", "15"}));
  EXPECT_EQ(labels(innerTicks(0, 0.0042, 5)),
            (std::vector<std::string>{"0.000", "0.001", "0.002", "0.003", "0.004"}));
  EXPECT_EQ(labels(innerTicks(-1500, 1500, 5)), (std::vector<std::string>{"-1000", "0", "1000"}));
}

// Expected by hand; the first three units appear in every plot of the gallery.
TEST(UnitInFormula, IsUprightWithThinSpacesBetweenFactors) {
  EXPECT_EQ(unitInFormula("rad/s"), "\\mathrm{rad/s}");
  EXPECT_EQ(unitInFormula("kg m^2/s"), "\\mathrm{kg\\,m^2/s}");
  EXPECT_EQ(unitInFormula("deg"), "\\degree");
  EXPECT_EQ(unitInFormula("deg/hr"), "\\mathrm{deg/hr}");
  for (const char* unit : {"kg*m^2", "kg-m^2", "kg.m2", "kg·m²", "kg×m**2"})
    EXPECT_EQ(unitInFormula(unit), "\\mathrm{kg\\,m^2}") << unit;
  EXPECT_EQ(unitInFormula("rad s-1"), "\\mathrm{rad\\,s^{-1}}");
  EXPECT_EQ(unitInFormula("1/min"), "\\mathrm{1/min}");
  EXPECT_EQ(unitInFormula("%"), "\\mathrm{\\%}");
  EXPECT_EQ(unitInFormula("µm"), "\\mathrm{}\\text{µ}\\mathrm{m}");
}

struct Random {
  std::mt19937_64 engine{11};
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  }
};

void expectTicks(const Ticks& ticks) {
  EXPECT_TRUE(ticks.digit == 1 || ticks.digit == 2 || ticks.digit == 5);
  for (auto i = ticks.first; i <= ticks.last; ++i) {
    const std::string digits = tickDigits(ticks, i);
    // Expected: the C library's decimal conversion, which rounds correctly.
    EXPECT_EQ(std::strtod(digits.c_str(), nullptr), ticks.at(i)) << digits;
    const std::size_t point = digits.find('.');
    EXPECT_EQ(point == std::string::npos ? 0 : digits.size() - point - 1,
              static_cast<std::size_t>(ticks.decimals()));
  }
}

TEST(PlotTicks, CoverAnyRangeWithFourToNineTicks) {
  Random random;
  for (int trial = 0; trial < 20000; ++trial) {
    const double length = std::pow(10.0, random.uniform(-9, 9));
    const double low = trial % 3 == 0 ? 0 : random.uniform(-3, 2) * length, high = low + length;
    const Ticks ticks = coveringTicks(low, high);
    SCOPED_TRACE(testing::Message() << low << " to " << high);
    EXPECT_GE(ticks.count(), 4);
    EXPECT_LE(ticks.count(), 9);
    EXPECT_LE(ticks.at(ticks.first), low + 2e-9 * ticks.step());
    EXPECT_GE(ticks.at(ticks.last), high - 2e-9 * ticks.step());
    // No tick could be left out.
    EXPECT_GT(ticks.at(ticks.first + 1), low);
    EXPECT_LT(ticks.at(ticks.last - 1), high);
    expectTicks(ticks);
  }
}

TEST(PlotTicks, StayInsideAnyRangeWithThreeToNineTicks) {
  Random random;
  for (int trial = 0; trial < 20000; ++trial) {
    const double length = std::pow(10.0, random.uniform(-9, 9));
    const bool fromZero = trial % 3 == 0;
    const double low = fromZero ? 0 : random.uniform(-3, 2) * length, high = low + length;
    const Ticks ticks = innerTicks(low, high);
    SCOPED_TRACE(testing::Message() << low << " to " << high);
    // There are 3 only if the range begins and ends between ticks: (0.6, 2.4) has 10 fifths and 3 halves.
    EXPECT_GE(ticks.count(), fromZero ? 4 : 3);
    EXPECT_LE(ticks.count(), 9);
    EXPECT_GE(ticks.at(ticks.first), low - 2e-9 * ticks.step());
    EXPECT_LE(ticks.at(ticks.last), high + 2e-9 * ticks.step());
    EXPECT_LT(ticks.at(ticks.first - 1), low);
    EXPECT_GT(ticks.at(ticks.last + 1), high);
    expectTicks(ticks);
  }
}

}  // namespace
}  // namespace poinsot::stage
