// SPDX-License-Identifier: Apache-2.0
#include "physics/elliptic.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using std::abs;
using std::sqrt;

/// Thresholds that end an iteration, because the remaining error is below the rounding of T. kQuadratic is for
/// means, whose error after the next step is (2e-9)^2/8 in double. kCarlson is for Carlson's series, whose error
/// is of order 8: (5e-3)^8 = 4e-19.
template <typename T>
struct Limits;
template <>
struct Limits<double> {
  static constexpr double kQuadratic = 2e-9;
  static constexpr double kCarlson = 5e-3;
};
template <>
struct Limits<DoubleDouble> {
  static constexpr double kQuadratic = 1e-17;
  static constexpr double kCarlson = 5e-5;
};

template <typename T>
T pi();
template <>
double pi() {
  return kPi.hi;
}
template <>
DoubleDouble pi() {
  return kPi;
}

template <typename T>
T ratio(int numerator, int denominator) {
  return T(numerator) / T(denominator);
}

/// Returns Carlson's series of R_F in e2 and e3, the elementary symmetric functions of the relative deviations
/// from the mean.
template <typename T>
T seriesRF(const T& e2, const T& e3) {
  const T e22 = e2 * e2;
  return T(1) - e2 * ratio<T>(1, 10) + e3 * ratio<T>(1, 14) + e22 * ratio<T>(1, 24) - e2 * e3 * ratio<T>(3, 44) -
         e22 * e2 * ratio<T>(5, 208) + e3 * e3 * ratio<T>(3, 104) + e22 * e3 * ratio<T>(1, 16);
}

double seriesRJ(double e2, double e3, double e4, double e5) {
  const double e22 = e2 * e2;
  return 1 + (-3 * e2 / 14 + e3 / 6 + 9 * e22 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26 - e22 * e2 / 16 +
              3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e22 * e3 / 272 - 9 * (e3 * e4 + e2 * e5) / 68);
}

/// Returns (sqrt a - sqrt b)/(sqrt a + sqrt b) from the difference a - b and the two roots.
double rootContrast(double difference, double rootA, double rootB) {
  const double sum = rootA + rootB;
  return difference / sum / sum;
}

}  // namespace

template <typename T>
T completeK(const T& mc) {
  T a(1), b = sqrt(mc);
  while (toDouble(a - b) > Limits<T>::kQuadratic * toDouble(a)) {
    const T mean = (a + b) * T(0.5);
    b = sqrt(a * b);
    a = mean;
  }
  return pi<T>() / (a + b);  // a + b is twice the arithmetic-geometric mean, up to rounding
}

template <typename T>
T carlsonRF(T x, T y, T z) {
  const T mean0 = (x + y + z) / T(3);
  const T deviationX = mean0 - x, deviationY = mean0 - y;
  const double spread = std::max({abs(toDouble(deviationX)), abs(toDouble(deviationY)), abs(toDouble(mean0 - z))});
  T mean = mean0;
  double power = 1;
  while (power * spread > Limits<T>::kCarlson * toDouble(mean)) {
    const T lambda = sqrt(x) * sqrt(y) + sqrt(x) * sqrt(z) + sqrt(y) * sqrt(z);
    x = (x + lambda) * T(0.25);
    y = (y + lambda) * T(0.25);
    z = (z + lambda) * T(0.25);
    mean = (mean + lambda) * T(0.25);
    power /= 4;
  }
  const T X = deviationX * T(power) / mean, Y = deviationY * T(power) / mean, Z = -(X + Y);
  return seriesRF<T>(X * Y - Z * Z, X * Y * Z) / sqrt(mean);
}

double carlsonRJ(double x, double y, double z, double p) {
  const double mean0 = (x + y + z + 2 * p) / 5;
  const double X0 = mean0 - x, Y0 = mean0 - y, Z0 = mean0 - z;
  const double px = p - x, py = p - y, pz = p - z;
  const double spread = std::max({abs(X0), abs(Y0), abs(Z0), abs(mean0 - p)});
  double mean = mean0, power = 1, sum = 0;
  while (power * spread > Limits<double>::kCarlson * mean) {
    const double rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), rp = sqrt(p);
    // e is computed as a product, because the textbook formula delta/d^2 underflows near the separatrix.
    const double e =
        rootContrast(power * px, rp, rx) * rootContrast(power * py, rp, ry) * rootContrast(power * pz, rp, rz);
    sum += power / ((rp + rx) * (rp + ry) * (rp + rz)) * arcTangentQuotient(std::max(e, 0.0));  // R_C(1, 1 + e)
    const double lambda = rx * ry + rx * rz + ry * rz;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
    mean = (mean + lambda) / 4;
    power /= 4;
  }
  const double X = power * X0 / mean, Y = power * Y0 / mean, Z = power * Z0 / mean, P = -(X + Y + Z) / 2;
  const double xyz = X * Y * Z, e2 = X * Y + X * Z + Y * Z - 3 * P * P;
  const double e3 = xyz + 2 * e2 * P + 4 * P * P * P, e4 = (2 * xyz + e2 * P + 3 * P * P * P) * P;
  return power * seriesRJ(e2, e3, e4, xyz * P * P) / (mean * sqrt(mean)) + 6 * sum;
}

template <typename T>
T cel(T kc, T p, T a, T b) {
  T arithmetic(1), geometricProduct = kc, root = sqrt(p);
  b = b / root;
  for (;;) {
    const T before = a, step = geometricProduct / root;
    a = a + b / root;
    b = (b + before * step) * T(2);
    root = root + step;
    const T mean = arithmetic;
    arithmetic = arithmetic + kc;
    if (abs(toDouble(mean - kc)) <= Limits<T>::kQuadratic * toDouble(mean)) break;
    kc = sqrt(geometricProduct) * T(2);
    geometricProduct = kc * arithmetic;
  }
  return pi<T>() * T(0.5) * (b + a * arithmetic) / (arithmetic * (arithmetic + root));
}

template double completeK(const double&);
template DoubleDouble completeK(const DoubleDouble&);
template double carlsonRF(double, double, double);
template DoubleDouble carlsonRF(DoubleDouble, DoubleDouble, DoubleDouble);
template double cel(double, double, double, double);
template DoubleDouble cel(DoubleDouble, DoubleDouble, DoubleDouble, DoubleDouble);

// All function values depend on these means. They are therefore computed in double-double and rounded only once.
JacobiFunctions::JacobiFunctions(const DoubleDouble& mc) : mc_(toDouble(mc)) {
  POINSOT_EXPECT(mc.hi >= 0 && mc.hi <= 1);
  if (mc_ == 0) return;
  DoubleDouble a = 1, b = sqrt(mc);
  for (bool last = false; !last; ++levels_) {
    POINSOT_ASSERT(levels_ < kMaxLevels);
    arithmetic_[levels_] = toDouble(a);
    geometric_[levels_] = toDouble(b);
    last = toDouble(a - b) <= Limits<double>::kQuadratic * toDouble(a);
    const DoubleDouble mean = (a + b) * 0.5;
    b = sqrt(a * b);
    a = mean;
  }
  agm_ = toDouble(a);
}

// Applies the descending Landen transformation to the cotangent of the amplitude. Begins at the level at which sn
// and cn are a sine and a cosine, and goes up to level 0. Source: R. Bulirsch, Numer. Math. 7 (1965) 78.
SnCnDn JacobiFunctions::at(double u) const {
  if (mc_ == 0) {
    const HyperbolicPair h = hyperbolicPair(u);
    return {h.tanh, h.sech, h.sech};
  }
  // Below kTiny, sn = u and cn = dn = 1 up to rounding, and the cotangent could overflow.
  constexpr double kTiny = 0x1p-28;
  if (abs(u) < kTiny) return {u, 1, 1};
  const SineCosine angle = sineCosine(u * agm_);
  double cotangent = angle.cosine / angle.sine;
  double c = cotangent * agm_, d = 1;
  for (std::size_t level = levels_; level-- > 0;) {
    const double product = cotangent * c;
    c *= d;
    d = (geometric_[level] + product) / (arithmetic_[level] + product);
    cotangent = c / arithmetic_[level];
  }
  const double sn = std::copysign(1 / sqrt(1 + c * c), angle.sine);
  const double cn = c * sn;
  return {sn, cn, sqrt(cn * cn + mc_ * sn * sn)};
}

}  // namespace poinsot::physics
