// SPDX-License-Identifier: Apache-2.0
#include "physics/double_double.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "physics/expansion.h"
#include "physics/random_bodies.h"
#include "physics/residual.h"

// Boost.Multiprecision computes the expected values to 100 digits from the exact operands.

namespace poinsot::physics {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

Real exact(const DoubleDouble& a) { return Real(a.hi) + Real(a.lo); }

double relativeError(const DoubleDouble& measured, const Real& expected) {
  return static_cast<double>(Real(abs(Real((exact(measured) - expected) / expected))));
}

DoubleDouble randomOperand(Draw& draw) {
  const double hi = draw.sign() * draw.decade(-3, 3);
  return twoSum(hi, hi * draw.between(-1, 1) * 0x1p-54);
}

TEST(DoubleDouble, OperationsAreAccurateTo103Bits) {
  Draw draw(21);
  double sum = 0, product = 0, quotient = 0, root = 0;
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = randomOperand(draw), b = randomOperand(draw);
    sum = std::max(sum, relativeError(a + b, exact(a) + exact(b)));
    product = std::max(product, relativeError(a * b, exact(a) * exact(b)));
    quotient = std::max(quotient, relativeError(a / b, exact(a) / exact(b)));
    root = std::max(root, relativeError(sqrt(abs(a)), sqrt(Real(abs(exact(a))))));
  }
  constexpr double kBound = 0x1p-103;            // 9.9e-32
  expectResidual("sum", sum, kBound);            // measured 2.1e-32
  expectResidual("product", product, kBound);    // measured 2.4e-32
  expectResidual("quotient", quotient, kBound);  // measured 2e-32
  expectResidual("square root", root, kBound);   // measured 3e-32
}

TEST(DoubleDouble, ErrorFreeTransformsAreExact) {
  Draw draw(22);
  for (int i = 0; i < 1000; ++i) {
    const double a = draw.sign() * draw.decade(-9, 9), b = draw.sign() * draw.decade(-9, 9);
    EXPECT_EQ(exact(twoSum(a, b)), Real(a) + Real(b));
    EXPECT_EQ(exact(twoProduct(a, b)), Real(a) * Real(b));
  }
}

TEST(DoubleDouble, PiHas106Bits) { EXPECT_LE(relativeError(kPi, boost::math::constants::pi<Real>()), 0x1p-106); }

TEST(DoubleDouble, SquareRootOfZeroIsZero) { EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0)); }

TEST(DoubleDouble, ReducesLargePhasesAccurately) {
  Draw draw(23);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = draw.sign() * draw.decade(0, 14);
    const Reduced r = reduced(x, kTwoPi);
    EXPECT_LE(std::abs(r.rest.hi), 3.1415927);
    const Real expected = Real(x) - Real(r.multiple) * exact(kTwoPi);
    worst = std::max(worst, static_cast<double>(Real(abs(Real(exact(r.rest) - expected)))));
  }
  expectResidual("rest of up to 1e14 turns, rad", worst, 2e-17);  // measured 6.3e-19
}

TEST(DoubleDouble, ReductionOfHugePhasesStaysInRange) {
  for (const double x : {1e20, -1e40, 1e150, 1e290}) {
    const Reduced r = reduced(x, kTwoPi);
    EXPECT_LE(std::abs(r.rest.hi), 3.1415930) << x;
  }
}

TEST(Expansion, AddsCancellingTermsExactly) {
  Draw draw(24);
  for (int i = 0; i < 300; ++i) {
    const double a = draw.between(0.1, 1), b = draw.between(0.1, 1), c = draw.between(0.1, 1);
    Expansion sum;
    sum.add(a);
    sum.add(-b);
    sum.scale(a);
    sum.scale(c);
    sum.scale(c);
    Expansion rest = sum;
    const DoubleDouble head = sum.value();
    rest.add(-head.hi);
    rest.add(-head.lo);
    const Real exactSum = (Real(a) - Real(b)) * Real(a) * Real(c) * Real(c);
    EXPECT_LE(relativeError(head, exactSum), 0x1p-104);
    // The rest beyond 106 bits is itself known to 100 bits.
    const Real left = exactSum - exact(head);
    if (left != 0) {
      EXPECT_LE(relativeError(rest.value(), left), 0x1p-100);
    }
  }
}

TEST(Expansion, IsZeroOnlyForZero) {
  Expansion sum;
  sum.add(1);
  sum.add(0x1p-300);
  sum.add(-1);
  EXPECT_EQ(sum.value(), DoubleDouble(0x1p-300));
  sum.add(-0x1p-300);
  EXPECT_EQ(sum.value(), DoubleDouble(0));
}

}  // namespace
}  // namespace poinsot::physics
