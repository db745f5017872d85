// SPDX-License-Identifier: Apache-2.0
#include "physics/transcendental.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "physics/random_bodies.h"
#include "physics/residual.h"

// Expected values: Boost.Multiprecision at 50 digits, of the exact argument.

namespace poinsot::physics {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// Error in units of the last place of the expected double.
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

TEST(Transcendental, SineAndCosine) {
  const auto turns = [](Draw& draw) { return draw.between(-7, 7); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0); };
  const auto sin50 = [](const Real& x) { return Real(sin(x)); };
  const auto cos50 = [](const Real& x) { return Real(cos(x)); };
  expectResidual("sin, ulp", worstUlps(1, turns, sine, sin50), 1);          // measured 0.74
  expectResidual("cos, ulp", worstUlps(2, turns, cosine, cos50), 1);        // measured 0.75
  expectResidual("sin small, ulp", worstUlps(3, small, sine, sin50), 1);    // measured 0.63
  expectResidual("cos small, ulp", worstUlps(4, small, cosine, cos50), 1);  // measured 0.68
}

TEST(Transcendental, ArcTangent) {
  const auto any = [](Draw& draw) { return draw.sign() * draw.decade(-20, 20); };
  const auto near1 = [](Draw& draw) { return draw.between(-3, 3); };
  const auto atan50 = [](const Real& x) { return Real(atan(x)); };
  expectResidual("atan, ulp", worstUlps(5, any, arcTangent, atan50), 1);           // measured 0.88
  expectResidual("atan near 1, ulp", worstUlps(6, near1, arcTangent, atan50), 1);  // measured 0.98
  EXPECT_EQ(arcTangent(std::numeric_limits<double>::infinity()), kHalfPi.hi);
  EXPECT_EQ(arcTangent(-std::numeric_limits<double>::infinity()), -kHalfPi.hi);
  EXPECT_EQ(arcTangent(0), 0);
}

TEST(Transcendental, Exponential) {
  const auto range = [](Draw& draw) { return draw.between(-700, 700); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0); };
  const auto exp50 = [](const Real& x) { return Real(exp(x)); };
  expectResidual("exp, ulp", worstUlps(7, range, exponential, exp50), 1);        // measured 0.85
  expectResidual("exp small, ulp", worstUlps(8, small, exponential, exp50), 1);  // measured 0.73
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-800), 0);
}

TEST(Transcendental, Logarithm) {
  const auto any = [](Draw& draw) { return draw.decade(-300, 300); };
  const auto near1 = [](Draw& draw) { return 1 + draw.sign() * draw.decade(-15, -0.5); };
  const auto log50 = [](const Real& x) { return Real(log(x)); };
  expectResidual("log, ulp", worstUlps(21, any, logarithm, log50), 1);           // measured 0.5
  expectResidual("log near 1, ulp", worstUlps(22, near1, logarithm, log50), 1);  // measured 0.501
  EXPECT_EQ(logarithm(1), 0);
}

TEST(Transcendental, HyperbolicPair) {
  const auto range = [](Draw& draw) { return draw.between(-40, 40); };
  const auto small = [](Draw& draw) { return draw.sign() * draw.decade(-20, 0.5); };
  const auto tanh50 = [](const Real& x) { return Real(tanh(x)); };
  const auto sech50 = [](const Real& x) { return Real(1 / cosh(x)); };
  expectResidual("tanh, ulp", worstUlps(9, range, tanhOf, tanh50), 3);         // measured 2.2
  expectResidual("tanh small, ulp", worstUlps(10, small, tanhOf, tanh50), 3);  // measured 2.2
  expectResidual("sech, ulp", worstUlps(11, range, sechOf, sech50), 3);        // measured 1.9
  expectResidual("sech small, ulp", worstUlps(12, small, sechOf, sech50), 3);  // measured 1.8
  EXPECT_EQ(hyperbolicPair(-1e4).tanh, -1);
  EXPECT_EQ(hyperbolicPair(1e4).sech, 0);
}

}  // namespace
}  // namespace poinsot::physics
