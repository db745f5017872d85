// SPDX-License-Identifier: Apache-2.0
#include "physics/transcendental.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "physics/random_bodies.h"
#include "physics/residual.h"

// Boost.Multiprecision computes the expected values to 50 digits from the exact argument.

namespace poinsot::physics {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// Returns the error in units of the last place of the expected double.
double ulps(double measured, const Real& expected) {
  const double rounded = std::abs(static_cast<double>(expected));
  const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return std::abs(static_cast<double>(Real((Real(measured) - expected) / ulp)));
}

double worstUlps(std::uint64_t seed, const std::function<double(Draw&)>& argument, double (*measured)(double),
                 const std::function<Real(const Real&)>& expected) {
  Draw draw(seed);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = argument(draw);
    worst = std::max(worst, ulps(measured(x), expected(Real(x))));
  }
  return worst;
}

const auto sine = [](double x) { return sineCosine(x).sine; };
const auto cosine = [](double x) { return sineCosine(x).cosine; };
const auto tanhOf = [](double x) { return hyperbolicPair(x).tanh; };
const auto sechOf = [](double x) { return hyperbolicPair(x).sech; };

Real exact(const DoubleDouble& x) { return Real(x.hi) + Real(x.lo); }

TEST(Transcendental, SineAndCosineAreWithinOneUlp) {
  const auto turns = [](Draw& draw) { return draw.between(-7, 7); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0); };
  const auto sin50 = [](const Real& x) { return Real(sin(x)); };
  const auto cos50 = [](const Real& x) { return Real(cos(x)); };
  expectResidual("sin, ulp", worstUlps(1, turns, sine, sin50), 1);          // measured 0.74
  expectResidual("cos, ulp", worstUlps(2, turns, cosine, cos50), 1);        // measured 0.75
  expectResidual("sin small, ulp", worstUlps(3, small, sine, sin50), 1);    // measured 0.63
  expectResidual("cos small, ulp", worstUlps(4, small, cosine, cos50), 1);  // measured 0.68
}

TEST(Transcendental, SineAndCosineOfADoubleDoubleAreWithinOneUlp) {
  Draw draw(13);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const double hi = draw.sign() * draw.decade(-3, 9);
    const DoubleDouble angle = twoSum(hi, hi * draw.between(-1, 1) * 0x1p-54);
    const SineCosine measured = sineCosine(angle);
    worst = std::max(
        {worst, ulps(measured.sine, Real(sin(exact(angle)))), ulps(measured.cosine, Real(cos(exact(angle))))});
  }
  expectResidual("sin and cos to 1e9 rad, ulp", worst, 1);  // measured 0.75
}

/// At the doubles nearest to multiples of pi/2, the 106 bits of pi/2 limit the accuracy of the remaining angle.
TEST(Transcendental, SineAndCosineAreAccurateAtTheirZeros) {
  double worst = 0;
  for (int k = 1; k < 2000000; k = 3 * k + 1) {
    const double angle = (kHalfPi * DoubleDouble(k)).hi;
    const SineCosine measured = sineCosine(angle);
    const Real error =
        k % 2 == 0 ? Real(Real(measured.sine) - sin(Real(angle))) : Real(Real(measured.cosine) - cos(Real(angle)));
    worst = std::max(worst, std::abs(static_cast<double>(error)) / angle);
  }
  expectResidual("sin and cos at their zeros, of the angle", worst, 0x1p-103);  // measured 5.6e-33
}

TEST(Transcendental, ArcTangentIsWithinOneUlp) {
  const auto any = [](Draw& draw) { return draw.sign() * draw.decade(-20, 20); };
  const auto near1 = [](Draw& draw) { return draw.between(-3, 3); };
  // Arguments where one term of the table takes over from the next, and where the result is just below a power of
  // two.
  const auto seams = [](Draw& draw) {
    const double seam = std::round(draw.between(0, 17)) / 16 * (1 + draw.between(-1, 1) * 0x1p-8);
    return draw.sign() > 0 ? seam : 1 / (seam + 0x1p-40);
  };
  const auto atan50 = [](const Real& x) { return Real(atan(x)); };
  expectResidual("atan, ulp", worstUlps(5, any, arcTangent, atan50), 1);                  // measured 0.55
  expectResidual("atan near 1, ulp", worstUlps(6, near1, arcTangent, atan50), 1);         // measured 0.60
  expectResidual("atan at its seams, ulp", worstUlps(14, seams, arcTangent, atan50), 1);  // measured 0.60
  EXPECT_EQ(arcTangent(std::numeric_limits<double>::infinity()), kHalfPi.hi);
  EXPECT_EQ(arcTangent(-std::numeric_limits<double>::infinity()), -kHalfPi.hi);
  EXPECT_EQ(arcTangent(std::numeric_limits<double>::max()), kHalfPi.hi);
  EXPECT_EQ(arcTangent(0), 0);
}

TEST(Transcendental, ExponentialLessOneIsWithinOneUlp) {
  const auto moderate = [](Draw& draw) { return draw.between(-60, 5); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0); };
  const auto expm1_50 = [](const Real& x) { return Real(expm1(x)); };
  expectResidual("exp - 1, ulp", worstUlps(16, moderate, exponentialLessOne, expm1_50), 1);     // measured 0.51
  expectResidual("exp - 1 small, ulp", worstUlps(17, small, exponentialLessOne, expm1_50), 1);  // measured 0.75
  EXPECT_EQ(exponentialLessOne(0), 0);
  EXPECT_EQ(exponentialLessOne(-1e9), -1);
}

TEST(Transcendental, ArcTangentQuotientIsWithinTwoUlps) {
  const auto any = [](Draw& draw) { return draw.decade(-20, 20); };
  const auto seam = [](Draw& draw) { return draw.between(0.03, 0.04); };
  const auto quotient50 = [](const Real& e) { return Real(atan(Real(sqrt(e))) / sqrt(e)); };
  expectResidual("atan(sqrt e)/sqrt e, ulp", worstUlps(23, any, arcTangentQuotient, quotient50),
                 2);                                                                             // measured 1.7
  expectResidual("  at its seam, ulp", worstUlps(24, seam, arcTangentQuotient, quotient50), 2);  // measured 1.3
  EXPECT_EQ(arcTangentQuotient(0), 1);
}

TEST(Transcendental, ExponentialIsWithinOneUlp) {
  const auto range = [](Draw& draw) { return draw.between(-700, 700); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0); };
  const auto moderate = [](Draw& draw) { return draw.between(-5, 5); };
  const auto subnormal = [](Draw& draw) { return draw.between(-745, -708); };
  const auto exp50 = [](const Real& x) { return Real(exp(x)); };
  expectResidual("exp, ulp", worstUlps(7, range, exponential, exp50), 1);                 // measured 0.51
  expectResidual("exp small, ulp", worstUlps(8, small, exponential, exp50), 1);           // measured 0.51
  expectResidual("exp moderate, ulp", worstUlps(15, moderate, exponential, exp50), 1);    // measured 0.51
  expectResidual("exp subnormal, ulp", worstUlps(16, subnormal, exponential, exp50), 1);  // measured 0.75
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-800), 0);
}

TEST(Transcendental, LogarithmIsWithinOneUlp) {
  const auto any = [](Draw& draw) { return draw.decade(-300, 300); };
  const auto near1 = [](Draw& draw) { return 1 + draw.sign() * draw.decade(-15, -0.5); };
  const auto log50 = [](const Real& x) { return Real(log(x)); };
  expectResidual("log, ulp", worstUlps(21, any, logarithm, log50), 1);           // measured 0.5
  expectResidual("log near 1, ulp", worstUlps(22, near1, logarithm, log50), 1);  // measured 0.501
  EXPECT_EQ(logarithm(1), 0);
}

TEST(Transcendental, HyperbolicPairIsWithinOneUlp) {
  const auto range = [](Draw& draw) { return draw.between(-40, 40); };
  const auto middle = [](Draw& draw) { return draw.between(-2, 2); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0.5); };
  const auto large = [](Draw& draw) { return draw.sign() * draw.decade(1, 2.85); };
  const auto tanh50 = [](const Real& x) { return Real(tanh(x)); };
  const auto sech50 = [](const Real& x) { return Real(1 / cosh(x)); };
  expectResidual("tanh, ulp", worstUlps(9, range, tanhOf, tanh50), 1);           // measured 0.51
  expectResidual("tanh middle, ulp", worstUlps(17, middle, tanhOf, tanh50), 1);  // measured 0.53
  expectResidual("tanh small, ulp", worstUlps(10, small, tanhOf, tanh50), 1);    // measured 0.52
  expectResidual("sech, ulp", worstUlps(11, range, sechOf, sech50), 1);          // measured 0.51
  expectResidual("sech middle, ulp", worstUlps(18, middle, sechOf, sech50), 1);  // measured 0.51
  expectResidual("sech small, ulp", worstUlps(12, small, sechOf, sech50), 1);    // measured 0.51
  expectResidual("sech large, ulp", worstUlps(19, large, sechOf, sech50), 1);    // measured 0.52
  EXPECT_EQ(hyperbolicPair(0).tanh, 0);
  EXPECT_EQ(hyperbolicPair(0).sech, 1);
  EXPECT_EQ(hyperbolicPair(-1e4).tanh, -1);
  EXPECT_EQ(hyperbolicPair(1e4).sech, 0);
}

// A step of the integrator that is far too long passes such arguments.
TEST(Transcendental, NaNGivesNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(arcTangent(nan)));
  EXPECT_TRUE(std::isnan(arcTangentQuotient(nan)));
  EXPECT_TRUE(std::isnan(exponential(nan)));
  EXPECT_TRUE(std::isnan(exponentialLessOne(nan)));
  EXPECT_TRUE(std::isnan(hyperbolicPair(nan).tanh));
  EXPECT_TRUE(std::isnan(sineCosine(nan).sine));
  for (const double x : {1e10, 1e300, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(std::isfinite(exponential(x))) << x;
}

}  // namespace
}  // namespace poinsot::physics
