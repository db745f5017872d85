// SPDX-License-Identifier: Apache-2.0
#include "physics/elliptic.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "physics/random_bodies.h"
#include "physics/residual.h"

// Boost.Math computes the expected values with 60 digits, in which k = sqrt(1 - mc) keeps enough of mc. Where
// Boost lacks a function, a trapezoidal sum replaces it, which converges geometrically for a periodic integrand.

namespace poinsot::physics {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

Real exact(double a) { return Real(a); }
Real exact(const DoubleDouble& a) { return Real(a.hi) + Real(a.lo); }

template <typename T>
double relativeError(const T& measured, const Real& expected) {
  return static_cast<double>(Real(abs(Real((exact(measured) - expected) / expected))));
}

Real modulus(double mc) { return sqrt(Real(1 - Real(mc))); }

TEST(Elliptic, CompleteKMatchesBoost) {
  Draw draw(31);
  double worst = 0, worstDD = 0;
  for (int i = 0; i < 300; ++i) {
    const double mc = draw.decade(-25, 0);
    const Real expected = boost::math::ellint_1(modulus(mc));
    worst = std::max(worst, relativeError(completeK(mc), expected));
    worstDD = std::max(worstDD, relativeError(completeK(DoubleDouble(mc)), expected));
  }
  expectResidual("K, double", worst, 1e-15);           // measured 5.1e-16
  expectResidual("K, double-double", worstDD, 1e-30);  // measured 3.7e-32
  EXPECT_EQ(completeK(1.0), kHalfPi.hi);
}

TEST(Elliptic, CompleteKIsAccurateAtTheSeparatrix) {
  // K = ln(4/sqrt(mc)) + O(mc log mc), DLMF 19.12.1
  const double mc = 0x1p-800;
  const Real expected = log(Real(4)) + 400 * log(Real(2));
  expectResidual("K at 2^-800", relativeError(completeK(DoubleDouble(mc)), expected), 1e-30);  // measured 1.5e-32
}

TEST(Elliptic, CarlsonRFMatchesBoost) {
  Draw draw(32);
  double worst = 0, worstDD = 0;
  for (int i = 0; i < 300; ++i) {
    const double x = i % 5 == 0 ? 0 : draw.decade(-20, 0), y = draw.decade(-20, 0), z = draw.decade(-2, 1);
    const Real expected = boost::math::ellint_rf(Real(x), Real(y), Real(z));
    worst = std::max(worst, relativeError(carlsonRF(x, y, z), expected));
    worstDD = std::max(worstDD, relativeError(carlsonRF<DoubleDouble>(x, y, z), expected));
  }
  expectResidual("R_F, double", worst, 2e-15);           // measured 4.7e-16
  expectResidual("R_F, double-double", worstDD, 1e-30);  // measured 5.8e-32
}

TEST(Elliptic, CarlsonRJMatchesBoost) {
  Draw draw(33);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    // Free motion uses the arguments x = cn^2 <= p <= y = dn^2 <= 1.
    const double mc = draw.decade(-20, 0), g = 1 + draw.decade(-10, 10),
                 cn2 = i % 5 == 0 ? 0 : draw.decade(-20, 0);
    const double p = cn2 + mc / g * (1 - cn2), y = std::max(p, cn2 + mc * (1 - cn2));
    const Real expected = boost::math::ellint_rj(Real(cn2), Real(y), Real(1), Real(p));
    worst = std::max(worst, relativeError(carlsonRJ(cn2, y, 1, p), expected));
  }
  expectResidual("R_J, double", worst, 4e-15);  // measured 7.5e-16
}

TEST(Elliptic, CelMatchesBoost) {
  Draw draw(34);
  double worst = 0, worstDD = 0;
  for (int i = 0; i < 300; ++i) {
    // cel(kc, p, 1, 1) = Pi(n = 1 - p, k), with a negative characteristic, as in free motion.
    const double mc = draw.decade(-18, 0), p = 1 + draw.decade(-6, 6);
    const DoubleDouble kc = sqrt(DoubleDouble(mc));
    const Real expected = boost::math::ellint_3(modulus(mc), Real(1 - Real(p)));
    worst = std::max(worst, relativeError(cel(toDouble(kc), p, 1.0, 1.0), expected));
    worstDD = std::max(worstDD, relativeError(cel<DoubleDouble>(kc, p, 1, 1), expected));
  }
  expectResidual("cel, double", worst, 4e-15);           // measured 7.9e-16
  expectResidual("cel, double-double", worstDD, 2e-30);  // measured 6.8e-32
}

/// Returns the trapezoidal sum over 0..pi/2 of the even, pi-periodic integrand of cel(kc, p, 1, 0).
Real celByQuadrature(const Real& kc, const Real& p, int panels) {
  const Real step = boost::math::constants::half_pi<Real>() / panels;
  Real sum = 0;
  for (int i = 0; i <= panels; ++i) {
    const Real c = cos(step * i), s = sin(step * i), c2 = c * c, s2 = s * s;
    const Real term = c2 / ((c2 + p * s2) * sqrt(Real(c2 + kc * kc * s2)));
    sum += i == 0 || i == panels ? Real(term / 2) : term;
  }
  return sum * step;
}

TEST(Elliptic, CelMatchesQuadratureAsUsedForTheAttitude) {
  for (const double p : {1.0, 1.5, 4.0})
    for (const double kc : {0.5, 0.9}) {
      const Real expected = celByQuadrature(Real(kc), Real(p), 120);  // 120 panels: e^(-2 artanh(1/2) 120) = 1e-57
      expectResidual("cel(kc, p, 1, 0)", relativeError(cel<DoubleDouble>(kc, p, 1, 0), expected),
                     1e-30);  // measured 1.9e-32
    }
}

TEST(Elliptic, JacobiFunctionsMatchBoost) {
  Draw draw(35);
  double phase = 0, norm = 0;
  for (int i = 0; i < 400; ++i) {
    const double mc = i % 20 == 0 ? 1 : draw.decade(-25, 0);
    const double K = completeK(mc), u = i % 7 == 0 ? draw.sign() * draw.decade(-12, 0) : draw.between(-K, K);
    Real cn, dn;
    const Real sn = boost::math::jacobi_elliptic(modulus(mc), Real(u), &cn, &dn);
    const SnCnDn f = JacobiFunctions(mc).at(u);
    // The error as a shift of u: the angle from the expected (sn, cn), divided by its rate dn.
    const Real angle = (Real(f.sn) * cn - Real(f.cn) * sn) / dn;
    phase = std::max(phase, std::abs(static_cast<double>(angle)) / std::max(1.0, std::abs(u)));
    norm = std::max(norm, std::abs(f.sn * f.sn + f.cn * f.cn - 1));
    EXPECT_NEAR(f.dn, static_cast<double>(dn), 4e-15 * std::max(1.0, std::abs(u)) * static_cast<double>(dn));
  }
  expectResidual("sn, cn, dn as a shift of u, relative", phase, 2e-15);  // measured 4.8e-16
  expectResidual("sn^2 + cn^2 - 1", norm, 1e-15);                        // measured 4.4e-16
}

TEST(Elliptic, JacobiFunctionsAreExactAtTheEnds) {
  const JacobiFunctions functions(0.25);
  EXPECT_EQ(functions.at(0).sn, 0);
  EXPECT_EQ(functions.at(0).cn, 1);
  const SnCnDn end = functions.at(completeK(0.25));
  EXPECT_EQ(end.sn, 1);
  EXPECT_NEAR(end.cn, 0, 4e-16);
  EXPECT_NEAR(end.dn, 0.5, 4e-16);  // sqrt(mc)
}

TEST(Elliptic, JacobiFunctionsRefuseAParameterOutOfRange) {
  EXPECT_THROW(JacobiFunctions(1.5), std::logic_error);
  EXPECT_THROW(JacobiFunctions(-0.5), std::logic_error);
}

}  // namespace
}  // namespace poinsot::physics
