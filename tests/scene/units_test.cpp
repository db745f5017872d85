// SPDX-License-Identifier: Apache-2.0
#include "scene/units.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <numbers>

namespace poinsot::scene {
namespace {

constexpr double kPi = std::numbers::pi;

struct Case {
  const char* text;
  Dimension dimension;
  double expected;
};

// Expected values: the definitions of the units (SI brochure; inch, foot, pound, ounce of 1959), by hand.
// Measured: exact in all but "12 ft", which is off by 2.2e-16, the last bit of a double.
TEST(Units, AreReadIntoSi) {
  const Case cases[] = {
      {"3 rpm", Dimension::kAngularVelocity, kPi / 10},
      {"15 deg", Dimension::kAngle, kPi / 12},
      {"90°", Dimension::kAngle, kPi / 2},
      {"306 d", Dimension::kTime, 26438400},
      {"20 cm", Dimension::kLength, 0.2},
      {"1.5 kg m^2", Dimension::kMomentOfInertia, 1.5},
      {"1.5 kg·m²", Dimension::kMomentOfInertia, 1.5},
      {"1.5 m*m*kg", Dimension::kMomentOfInertia, 1.5},
      {"2.5e4 g cm^2", Dimension::kMomentOfInertia, 2.5e-3},
      {"60 deg/s", Dimension::kAngularVelocity, kPi / 3},
      {"1 rev/s", Dimension::kAngularVelocity, 2 * kPi},
      {"0.5 Hz", Dimension::kAngularVelocity, kPi},
      {"360 deg s^-1", Dimension::kAngularVelocity, 2 * kPi},
      {"1 rev/d", Dimension::kAngularVelocity, 2 * kPi / 86400},
      {"1 h", Dimension::kTime, 3600},
      {"1 ms", Dimension::kTime, 1e-3},
      {"2µs", Dimension::kTime, 2e-6},
      {"23.9345 h", Dimension::kTime, 86164.2},
      {"1 yr", Dimension::kTime, 31557600},
      {"27 in", Dimension::kLength, 0.6858},
      {"12 ft", Dimension::kLength, 3.6576},
      {"16 oz", Dimension::kMass, 0.45359237},
      {"  +2.5kg ", Dimension::kMass, 2.5},
      {"-.5 m", Dimension::kLength, -0.5},
      {"3600 arcsec", Dimension::kAngle, kPi / 180},
      {"13 %", Dimension::kNone, 0.13},
      {"5 sec", Dimension::kTime, 5},
      {"190 grams", Dimension::kMass, 0.19},
      {"1 degree", Dimension::kAngle, kPi / 180},
      {"2 rps", Dimension::kAngularVelocity, 4 * kPi},
      {"5 seconds", Dimension::kTime, 5},
      {"180 degrees", Dimension::kAngle, kPi},
      {"2.7 g/cm^3", Dimension::kDensity, 2700},
      {"36 km/h", Dimension::kVelocity, 10},
      {"981 cm/s^2", Dimension::kAcceleration, 9.81},
      {"5 mN m", Dimension::kTorque, 5e-3},
      {"3 N*cm", Dimension::kTorque, 0.03},
      {"2 kJ", Dimension::kEnergy, 2000},
      {"1 kg m^2/s^2", Dimension::kEnergy, 1},
      {"4 J s", Dimension::kAngularMomentum, 4},
      {"4 g cm^2/s", Dimension::kAngularMomentum, 4e-7},
      {"6 /min", Dimension::kRate, 0.1},
      {"6 1/min", Dimension::kRate, 0.1},
      {"6 1 / min", Dimension::kRate, 0.1},
      {"6min^-1", Dimension::kRate, 0.1},
      {"2 s/kg/m^2", Dimension::kInverseAction, 2},
  };
  for (const Case& c : cases) {
    const Quantity read = parseQuantity(c.text, c.dimension);
    EXPECT_EQ(read.problem, "") << c.text;
    EXPECT_NEAR(read.value / c.expected, 1, 1e-15) << c.text;
  }
}

TEST(Units, OfTheWrongDimensionAreRefusedWithTheRightOnes) {
  EXPECT_EQ(parseQuantity("3 kg", Dimension::kTime).problem,
            "expected a time in one of s, ms, us, min, h, d, yr, got \"3 kg\"");
  EXPECT_EQ(parseQuantity("3 deg", Dimension::kAngularVelocity).problem,
            "expected an angular velocity in one of rad/s, deg/s, rpm, rev/s, rev/d, Hz, got \"3 deg\"");
  EXPECT_FALSE(parseQuantity("3 m^2", Dimension::kLength).ok());
  EXPECT_FALSE(parseQuantity("3 rad", Dimension::kNone).ok());
  EXPECT_FALSE(parseQuantity("3 Hz", Dimension::kRate).ok());  // turns, not a decay
  EXPECT_FALSE(parseQuantity("3 /", Dimension::kRate).ok());
  EXPECT_FALSE(parseQuantity("3 1", Dimension::kRate).ok());
}

TEST(Units, ThatAreNoneAreNamed) {
  EXPECT_EQ(parseQuantity("3 parsecs", Dimension::kLength).problem,
            "\"parsecs\" is not a known unit; expected a length in one of m, km, cm, mm, um, in, ft");
  EXPECT_EQ(parseQuantity("3", Dimension::kLength).problem,
            "\"3\" has no unit, such as m, km, cm, mm, um, in, ft; without quotes it is in m");
  for (const char* text : {"", " ", "m", "rpm 3", "3 m/", "3 /s", "3 m^", "3 m^99", "3 m^x", "--3 m", "+-3 m",
                           "3 m m m m m m m m m", "1e999 m", "3,5 m", "0x10 m", "3 m\x1b[31m", "3 \xff"})
    EXPECT_FALSE(parseQuantity(text, Dimension::kLength).ok()) << text;
}

TEST(Units, WrittenByAnotherHabitAreToldTheOneHere) {
  EXPECT_EQ(parseQuantity("1,5 s", Dimension::kTime).problem,
            "numbers have a decimal point, not a comma, got \"1,5 s\"");
  EXPECT_EQ(parseQuantity("1 kg m2", Dimension::kMomentOfInertia).value, 1);
  EXPECT_EQ(parseQuantity("7.5 g/cm3", Dimension::kDensity).value,
            parseQuantity("7.5 g/cm^3", Dimension::kDensity).value);
  EXPECT_FALSE(parseQuantity("3 m2", Dimension::kLength).ok());
  for (const char* wrong : {"3 m1", "3 m5", "3 m22", "3 m0"})
    EXPECT_FALSE(parseQuantity(wrong, Dimension::kLength).ok()) << wrong;
}

TEST(Units, OfARangeMustExist) {
  EXPECT_EQ(unitFactor("", Dimension::kTime), 1);
  EXPECT_EQ(unitFactor("h", Dimension::kTime), 3600);
  EXPECT_THROW(unitFactor("h", Dimension::kLength), std::logic_error);
  EXPECT_THROW(unitFactor("parsec", Dimension::kLength), std::logic_error);
}

TEST(Units, CannotCarryControlCharactersIntoAMessage) {
  EXPECT_EQ(parseQuantity("\x1b[31m", Dimension::kLength).problem.find('\x1b'), std::string::npos);
  EXPECT_EQ(parseQuantity("3 \xc2\x9b", Dimension::kLength).problem.find('\xc2'), std::string::npos);
}

// A German decimal comma would make 1.5 into 1. Where the locale is not installed, the C locale is tested again.
TEST(Units, DoNotDependOnTheLocale) {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const Quantity read = parseQuantity("1.5 m", Dimension::kLength);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(read.value, 1.5);
}

}  // namespace
}  // namespace poinsot::scene
