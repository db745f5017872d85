// SPDX-License-Identifier: Apache-2.0
#include "physics/transcendental.h"

#include <array>
#include <cmath>

namespace poinsot::physics {
namespace {

/// sum c[k] x^k by Horner.
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

/// sign^k / (first + step... )!: Taylor coefficients 1/first!, sign/(first+2)!, ...
template <std::size_t N>
constexpr std::array<double, N> inverseFactorials(int first, int step, double sign) {
  std::array<double, N> c{};
  double factorial = 1;  // exact in a double up to 22!
  for (int n = 2; n <= first; ++n) factorial *= n;
  double signed1 = 1;
  for (std::size_t k = 0; k < N; ++k) {
    c[k] = signed1 / factorial;
    for (int n = 1; n <= step; ++n) factorial *= first + step * static_cast<int>(k) + n;
    signed1 *= sign;
  }
  return c;
}

// The first term left out is below 1e-19 of the result on the interval named.
constexpr auto kSine = inverseFactorials<8>(3, 2, -1);         // (x - sin x)/x^3, |x| <= pi/4
constexpr auto kCosine = inverseFactorials<8>(4, 2, -1);       // (cos x - 1 + x^2/2)/x^4, |x| <= pi/4
constexpr auto kExponential = inverseFactorials<13>(2, 1, 1);  // (e^x - 1 - x)/x^2, |x| <= ln2/2
constexpr auto kSinh = inverseFactorials<9>(3, 2, 1);          // (sinh x - x)/x^3, |x| <= 1
constexpr std::array<double, 7> kArcTangent = {-1. / 3, 1. / 5, -1. / 7, 1. / 9, -1. / 11, 1. / 13, -1. / 15};

/// sin(x + tail), |x| <= pi/4; the tail enters to first order.
double sineNearZero(double x, double tail) {
  const double square = x * x;
  const double correction = -square * x * polynomial(kSine, square);
  return x + (correction + tail * (1 - 0.5 * square));
}

/// cos(x + tail), |x| <= pi/4.
double cosineNearZero(double x, double tail) {
  const double square = x * x;
  const double half = 0.5 * square;
  const double leading = 1 - half;
  const double lost = (1 - leading) - half;  // what rounding took from 1 - x^2/2
  return leading + (lost + (square * square * polynomial(kCosine, square) - x * tail));
}

/// atan(k/8) as hi + lo, k = 0..8.
constexpr std::array<DoubleDouble, 9> kArcTangentOfEighths = {{{0, 0},
                                                               {0.12435499454676144, -3.1253241424539383e-18},
                                                               {0.24497866312686414, 1.0698755618734451e-17},
                                                               {0.35877067027057225, -2.4623815582638635e-17},
                                                               {0.4636476090008061, 2.2698777452961687e-17},
                                                               {0.5585993153435624, -5.4556305485916264e-18},
                                                               {0.6435011087932844, 1.5834785051444286e-17},
                                                               {0.7188299996216245, -2.1478388444456983e-17},
                                                               {0.7853981633974483, 3.061616997868383e-17}}};

/// atan of numerator/denominator in [0, 1] as hi + lo: atan(k/8) plus the series of what is left, at most 1/16.
DoubleDouble arcTangentOfFraction(double numerator, double denominator) {
  const double nearest = std::round(8 * numerator / denominator);
  const double c = nearest / 8;
  const double t = (numerator - c * denominator) / (denominator + c * numerator);
  const double square = t * t;
  const double series = t + t * square * polynomial(kArcTangent, square);
  const DoubleDouble& base = kArcTangentOfEighths[static_cast<std::size_t>(nearest)];
  const DoubleDouble sum = twoSum(base.hi, series);
  return {sum.hi, sum.lo + base.lo};
}

constexpr std::array<double, 11> kArcTanh = {1. / 3,  1. / 5,  1. / 7,  1. / 9,  1. / 11, 1. / 13,
                                             1. / 15, 1. / 17, 1. / 19, 1. / 21, 1. / 23};  // |x| <= 3 - sqrt 8

constexpr DoubleDouble kLn2{0.6931471805599453, 2.3190468138462996e-17};
constexpr double kSmallestExponent = -746;  // e^-746 is below half the smallest subnormal

}  // namespace

SineCosine sineCosine(const DoubleDouble& angle) {
  const Reduced part = reduced(angle, kHalfPi);
  const double s = sineNearZero(part.rest.hi, part.rest.lo), c = cosineNearZero(part.rest.hi, part.rest.lo);
  const double quadrant = part.multiple - 4 * std::floor(part.multiple / 4);
  if (quadrant == 0) return {s, c};
  if (quadrant == 1) return {c, -s};
  if (quadrant == 2) return {-s, -c};
  return {-c, s};
}

double arcTangent(double x) {
  const double size = std::abs(x);
  if (size <= 1) {
    const DoubleDouble angle = arcTangentOfFraction(size, 1);
    return std::copysign(angle.hi + angle.lo, x);
  }
  const DoubleDouble complement = std::isinf(size) ? DoubleDouble(0) : arcTangentOfFraction(1, size);
  const DoubleDouble angle = kHalfPi - complement;
  return std::copysign(angle.hi + angle.lo, x);
}

double exponential(double x) {
  if (x < kSmallestExponent) return 0;
  const double n = std::round(x / kLn2.hi);
  const DoubleDouble rest = DoubleDouble(x) - kLn2 * DoubleDouble(n);
  const double r = rest.hi;
  const double power = 1 + (r + (r * r * polynomial(kExponential, r) + rest.lo));
  return std::ldexp(power, static_cast<int>(n));
}

// ln x = n ln 2 + 2 artanh t,  t = (f - 1)/(f + 1),  x = 2^n f,  f within sqrt 2 of 1.
double logarithm(double x) {
  constexpr double kRootHalf = 0.7071067811865476;
  int n = 0;
  double f = std::frexp(x, &n);
  if (f < kRootHalf) {
    f *= 2;
    --n;
  }
  const DoubleDouble t = DoubleDouble(f - 1) / twoSum(f, 1);
  const double square = t.hi * t.hi;
  const DoubleDouble leading = kLn2 * DoubleDouble(n) + t * DoubleDouble(2);
  return leading.hi + (leading.lo + 2 * t.hi * square * polynomial(kArcTanh, square));
}

HyperbolicPair hyperbolicPair(double u) {
  const double size = std::abs(u);
  const double e = exponential(-size);
  const double sech = 2 * e / (1 + e * e);
  if (size > 1) return {std::copysign((1 - e * e) / (1 + e * e), u), sech};
  // 1 - e^2 would cancel.
  const double square = u * u;
  return {(u + u * square * polynomial(kSinh, square)) * sech, sech};
}

}  // namespace poinsot::physics
