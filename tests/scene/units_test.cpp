// SPDX-License-Identifier: Apache-2.0
#include "scene/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "scene/unit_names.h"

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
TEST(Units, ConvertToSi) {
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

// Expected values: exact decimals, from lb = 0.45359237 kg, g_n = 9.80665 m/s², in = 0.0254 m, ft = 12 in, and so
// lbf = 4.4482216152605 N, slug ft² = lbf s² ft = 4.4482216152605 · 0.3048 kg m² = 1.3558179483314004 kg m²,
// lbf in s² = 4.4482216152605 · 0.0254 kg m²; u of CODATA 2022; mile 1609.344 m, nautical mile 1852 m.
// Measured: at most 2.3e-16, the last bit of a double.
TEST(Units, ConvertFromEngineeringUnitsAndNotations) {
  constexpr Dimension kMoment = Dimension::kMomentOfInertia, kSpin = Dimension::kAngularVelocity,
                      kTorque = Dimension::kTorque;
  const Case cases[] = {
      {"1 slug ft^2", kMoment, 1.3558179483314004},
      {"1 slug-ft2", kMoment, 1.3558179483314004},
      {"1 slugs*ft**2", kMoment, 1.3558179483314004},
      {"1 lbm in^2", kMoment, 2.926396534292e-4},
      {"1 lbf in s^2", kMoment, 0.1129848290276167},
      {"1 in-lbf-sec^2", kMoment, 0.1129848290276167},
      {"1 lbf s^2 in", kMoment, 0.1129848290276167},
      {"1 kgf m s^2", kMoment, 9.80665},
      {"1 N m s^2", kMoment, 1},
      {"1 oz in^2", kMoment, 1.82899783393250e-5},
      {"1 kg-m^2", kMoment, 1},
      {"1 kg - m^2", kMoment, 1},
      {"1 kg.m^2", kMoment, 1},
      {"1 kg*m**2", kMoment, 1},
      {"1 kg·m**2", kMoment, 1},
      {"1 kg×m²", kMoment, 1},
      {"1 kg⋅m2", kMoment, 1},
      {"1e-3 kg-m2", kMoment, 1e-3},
      {"1 gm cm^2", kMoment, 1e-7},
      {"1 gram centimetre^2", kMoment, 1e-7},
      {"1 kilograms millimeters^2", kMoment, 1e-6},
      {"1 mg m^2", kMoment, 1e-6},
      {"1 Mg m^2", kMoment, 1e3},
      {"1 u Å^2", kMoment, 1.66053906892e-47},
      {"1 u \u212b^2", kMoment, 1.66053906892e-47},
      {"1 amu angstrom^2", kMoment, 1.66053906892e-47},
      {"1 Da nm^2", kMoment, 1.66053906892e-45},
      {"1 kDa", Dimension::kMass, 1.66053906892e-24},
      {"5 μm", Dimension::kLength, 5e-6},
      {"1 yd", Dimension::kLength, 0.9144},
      {"96 pm", Dimension::kLength, 96e-12},
      {"2 miles", Dimension::kLength, 3218.688},
      {"1 nmi", Dimension::kLength, 1852},
      {"3 RPM", kSpin, kPi / 10},
      {"3 krpm", kSpin, 100 * kPi},
      {"3600 deg/hr", kSpin, kPi / 180},
      {"3600 deg/h", kSpin, kPi / 180},
      {"2 dps", kSpin, kPi / 90},
      {"1 mdeg/s", kSpin, kPi / 180000},
      {"1 mHz", kSpin, 2e-3 * kPi},
      {"1 kHz", kSpin, 2e3 * kPi},
      {"1 MHz", kSpin, 2e6 * kPi},
      {"1 gigahertz", kSpin, 2e9 * kPi},
      {"1 THz", kSpin, 2e12 * kPi},
      {"2 rad s-1", kSpin, 2},
      {"2 rad s⁻¹", kSpin, 2},
      {"2 rad-s**-1", kSpin, 2},
      {"648e6 mas", Dimension::kAngle, kPi},
      {"1 lbf ft", kTorque, 1.3558179483314004},
      {"1 ft-lbf", kTorque, 1.3558179483314004},
      {"1 ozf in", kTorque, 0.00706155181422604375},
      {"2 Nm", kTorque, 2},
      {"3 mNm", kTorque, 3e-3},
      {"3 Ncm", kTorque, 0.03},
      {"1 MN m", kTorque, 1e6},
      {"4 Nms", Dimension::kAngularMomentum, 4},
      {"1 slug ft^2/s", Dimension::kAngularMomentum, 1.3558179483314004},
      {"1 slug/ft^3", Dimension::kDensity, 515.378818393196},
      {"10 mph", Dimension::kVelocity, 4.4704},
      {"36 kph", Dimension::kVelocity, 10},
      {"1 knot", Dimension::kVelocity, 1852 / 3600.},
      {"5 ns", Dimension::kTime, 5e-9},
      {"2 hrs", Dimension::kTime, 7200},
  };
  for (const Case& c : cases) {
    const Quantity read = parseQuantity(c.text, c.dimension);
    EXPECT_EQ(read.problem, "") << c.text;
    EXPECT_NEAR(read.value / c.expected, 1, 1e-15) << c.text;
  }
}

// If two rows of the table had the same name, the first one's value would be used silently.
TEST(Units, HaveUniqueNames) {
  std::map<std::string, double> values;
  for (const NamedUnit& known : namedUnits()) {
    EXPECT_TRUE(values.emplace(known.name, known.unit.factor).second) << known.name;
    EXPECT_EQ(unitTerms(known.name).size(), 1u) << known.name;
  }
  EXPECT_GT(values.size(), 200u);
}

// A prefix must not cost a digit: kilogram is 1e3 · 1e-3 kg.
TEST(Units, PrefixedUnitsAreTheNearestDoubles) {
  const std::pair<const char*, double> units[] = {{"km", 1e3},  {"cm", 1e-2}, {"mm", 1e-3},  {"um", 1e-6},
                                                  {"nm", 1e-9}, {"kg", 1},    {"mg", 1e-6},  {"ug", 1e-9},
                                                  {"Mg", 1e3},  {"ms", 1e-3}, {"us", 1e-6},  {"mN", 1e-3},
                                                  {"kJ", 1e3},  {"mJ", 1e-3}, {"mrad", 1e-3}};
  for (const auto& [name, value] : units) EXPECT_EQ(unitNamed(name)->factor, value) << name;
}

TEST(Units, SuggestionsNeverChangeThePrefix) {
  const auto suggestion = [](const char* text, Dimension dimension) {
    const std::string problem = parseQuantity(text, dimension).problem;
    const auto at = problem.find("did you mean ");
    return at == std::string::npos ? std::string() : problem.substr(at + 13);
  };
  EXPECT_EQ(suggestion("3 Rpm", Dimension::kAngularVelocity), "\"rpm\"?");
  EXPECT_EQ(suggestion("3 KHZ", Dimension::kAngularVelocity), "\"kHz\"?");
  EXPECT_EQ(suggestion("3 DEG/SEC", Dimension::kAngularVelocity), "\"deg/sec\"?");
  EXPECT_EQ(suggestion("3 KG-M2", Dimension::kMomentOfInertia), "\"kg-m2\"?");
  EXPECT_EQ(suggestion("3 SLUG-FT2", Dimension::kMomentOfInertia), "\"slug-ft2\"?");
  EXPECT_EQ(suggestion("3 CM", Dimension::kLength), "\"cm\"?");
  for (const auto& [text, dimension] : {std::pair{"3 Mm", Dimension::kLength},
                                        {"3 MM", Dimension::kLength},
                                        {"3 MG", Dimension::kMass},
                                        {"3 MHZ", Dimension::kAngularVelocity},
                                        {"3 mhz", Dimension::kAngularVelocity},
                                        {"3 Mrad", Dimension::kAngle},
                                        {"3 Ms", Dimension::kTime},
                                        {"3 mn m", Dimension::kTorque},
                                        {"3 Pm", Dimension::kLength}})
    EXPECT_EQ(suggestion(text, dimension), "") << text;
}

TEST(Units, MassUnitsInTorquesSuggestForceUnits) {
  EXPECT_THAT(parseQuantity("3 lb ft", Dimension::kTorque).problem,
              testing::EndsWith("got \"3 lb ft\"; did you mean \"lbf ft\"?"));
  EXPECT_THAT(parseQuantity("3 lb-in-s^2", Dimension::kMomentOfInertia).problem,
              testing::EndsWith("did you mean \"lbf-in-s^2\"?"));
  EXPECT_THAT(parseQuantity("3 oz-in", Dimension::kTorque).problem, testing::EndsWith("did you mean \"ozf-in\"?"));
  EXPECT_EQ(parseQuantity("3 lb ft", Dimension::kMomentOfInertia).problem.find("did you mean"), std::string::npos);
}

TEST(Units, RejectDanglingSigns) {
  for (const char* text : {"3 kg-", "3 kg-m^2-", "3 -kg m^2", "3 kg--m^2", "3 kg..m^2", "3 kg*m***2", "3 kg m**",
                           "3 kg m⁻", "3 kg m^2 -1", "3 kg m-2", "3 kg m^-2"})
    EXPECT_FALSE(parseQuantity(text, Dimension::kMomentOfInertia).ok()) << text;
}

TEST(Units, AreSplitIntoTerms) {
  const auto terms = unitTerms("kg-m**2/s");
  ASSERT_EQ(terms.size(), 3u);
  EXPECT_EQ(terms[1].name, "m");
  EXPECT_EQ(terms[1].power, 2);
  EXPECT_FALSE(terms[1].divides);
  EXPECT_TRUE(terms[2].divides);
  EXPECT_TRUE(unitTerms("furlong").empty());
}

TEST(Units, ErrorsListUnitsOfTheRightDimension) {
  EXPECT_EQ(parseQuantity("3 kg", Dimension::kTime).problem,
            "expected a time in one of s, ms, us, min, h, d, yr (poinsot explain units lists all), got \"3 kg\"");
  EXPECT_EQ(parseQuantity("3 deg", Dimension::kAngularVelocity).problem,
            "expected an angular velocity in one of rad/s, deg/s, deg/h, rpm, rev/s, rev/d, Hz, kHz "
            "(poinsot explain units lists all), got \"3 deg\"");
  EXPECT_FALSE(parseQuantity("3 m^2", Dimension::kLength).ok());
  EXPECT_FALSE(parseQuantity("3 rad", Dimension::kNone).ok());
  EXPECT_FALSE(parseQuantity("3 Hz", Dimension::kRate).ok());  // Hz counts turns, not decay
  EXPECT_FALSE(parseQuantity("3 /", Dimension::kRate).ok());
  EXPECT_FALSE(parseQuantity("3 1", Dimension::kRate).ok());
}

TEST(Units, ErrorsNameTheUnknownUnit) {
  EXPECT_EQ(parseQuantity("3 parsecs", Dimension::kLength).problem,
            "\"parsecs\" is not a known unit; expected a length in one of m, km, cm, mm, um, in, ft, Å "
            "(poinsot explain units lists all)");
  EXPECT_EQ(parseQuantity("3", Dimension::kLength).problem,
            "\"3\" has no unit, such as m, km, cm, mm, um, in, ft, Å (poinsot explain units lists all); without "
            "quotes it is in m");
  for (const char* text : {"", " ", "m", "rpm 3", "3 m/", "3 /s", "3 m^", "3 m^99", "3 m^x", "--3 m", "+-3 m",
                           "3 m m m m m m m m m", "1e999 m", "3,5 m", "0x10 m", "3 m\x1b[31m", "3 \xff"})
    EXPECT_FALSE(parseQuantity(text, Dimension::kLength).ok()) << text;
}

TEST(Units, RejectDecimalCommasAndAcceptPlainExponents) {
  EXPECT_EQ(parseQuantity("1,5 s", Dimension::kTime).problem,
            "numbers have a decimal point, not a comma, got \"1,5 s\"");
  EXPECT_EQ(parseQuantity("1 kg m2", Dimension::kMomentOfInertia).value, 1);
  EXPECT_EQ(parseQuantity("7.5 g/cm3", Dimension::kDensity).value,
            parseQuantity("7.5 g/cm^3", Dimension::kDensity).value);
  EXPECT_FALSE(parseQuantity("3 m2", Dimension::kLength).ok());
  for (const char* wrong : {"3 m1", "3 m5", "3 m22", "3 m0"})
    EXPECT_FALSE(parseQuantity(wrong, Dimension::kLength).ok()) << wrong;
}

TEST(Units, ThrowALogicErrorForAnUnknownFactor) {
  EXPECT_EQ(unitFactor("", Dimension::kTime), 1);
  EXPECT_EQ(unitFactor("h", Dimension::kTime), 3600);
  EXPECT_THROW(unitFactor("h", Dimension::kLength), std::logic_error);
  EXPECT_THROW(unitFactor("parsec", Dimension::kLength), std::logic_error);
}

TEST(Units, MessagesContainNoControlCharacters) {
  EXPECT_EQ(parseQuantity("\x1b[31m", Dimension::kLength).problem.find('\x1b'), std::string::npos);
  EXPECT_EQ(parseQuantity("3 \xc2\x9b", Dimension::kLength).problem.find('\xc2'), std::string::npos);
}

// A German decimal comma would turn 1.5 into 1. If the locale is not installed, the C locale is tested again.
TEST(Units, DoNotDependOnTheLocale) {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const Quantity read = parseQuantity("1.5 m", Dimension::kLength);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(read.value, 1.5);
}

}  // namespace
}  // namespace poinsot::scene
