// SPDX-License-Identifier: Apache-2.0
#include "physics/transcendental.h"

#include <array>
#include <cmath>

namespace poinsot::physics {
namespace {

template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

/// Returns the Taylor coefficients 1/first!, sign/(first + step)!, 1/(first + 2 step)!, ...
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

// Coefficients of power series. On the interval given beside a series, its first omitted term is below 1e-19 of
// the result.
constexpr auto kSine = inverseFactorials<8>(3, 2, -1);         // (x - sin x)/x^3, |x| <= pi/4
constexpr auto kCosine = inverseFactorials<8>(4, 2, -1);       // (cos x - 1 + x^2/2)/x^4, |x| <= pi/4
constexpr auto kExponential = inverseFactorials<12>(3, 1, 1);  // (e^x - 1 - x - x^2/2)/x^3, |x| <= ln2/2
constexpr auto kSinh = inverseFactorials<6>(3, 2, 1);          // (sinh x - x)/x^3, |x| <= 1/4

/// Returns the coefficients first/3, sign first/5, first/7, ... of the series of the arctangent and of artanh.
template <std::size_t N>
constexpr std::array<double, N> oddInverses(double first, double sign) {
  std::array<double, N> c{};
  double signed1 = first;
  for (std::size_t k = 0; k < N; ++k, signed1 *= sign) c[k] = signed1 / (2.0 * static_cast<double>(k) + 3);
  return c;
}
constexpr auto kArcTangent = oddInverses<11>(-1, -1);  // (atan t - t)/t^3, |t| <= 3/16
constexpr auto kArcTanh = oddInverses<11>(1, 1);       // (artanh t - t)/t^3, |t| <= 3 - sqrt 8

/// Returns sin(x + tail) for |x| <= pi/4 and a tiny tail, whose square is neglected.
double sineNearZero(double x, double tail) {
  const double square = x * x;
  const double correction = -square * x * polynomial(kSine, square);
  return x + (correction + tail * (1 - 0.5 * square));
}

/// Returns cos(x + tail) for |x| <= pi/4 and a tiny tail, whose square is neglected.
double cosineNearZero(double x, double tail) {
  const double square = x * x;
  const double half = 0.5 * square;
  const double leading = 1 - half;
  const double lost = (1 - leading) - half;
  return leading + (lost + (square * square * polynomial(kCosine, square) - x * tail));
}

constexpr std::array<DoubleDouble, 9> kArcTangentOfEighths = {{{0, 0},
                                                               {0.12435499454676144, -3.1253241424539383e-18},
                                                               {0.24497866312686414, 1.0698755618734451e-17},
                                                               {0.35877067027057225, -2.4623815582638635e-17},
                                                               {0.4636476090008061, 2.2698777452961687e-17},
                                                               {0.5585993153435624, -5.4556305485916264e-18},
                                                               {0.6435011087932844, 1.5834785051444286e-17},
                                                               {0.7188299996216245, -2.1478388444456983e-17},
                                                               {0.7853981633974483, 3.061616997868383e-17}}};

/// Returns atan(numerator/denominator) for a quotient in [0, 1], as hi + lo. The result is atan(k/8) plus a series
/// of the rest, which is at most 1/16. k = 1 is replaced by 0, because the two terms would cancel; the rest is
/// then at most 3/16.
DoubleDouble arcTangentOfFraction(double numerator, double denominator) {
  double nearest = std::round(8 * numerator / denominator);
  if (nearest == 1) nearest = 0;
  const double c = nearest / 8;
  const DoubleDouble halves = splitInHalves(denominator);
  const double rest = (numerator - c * halves.hi) - c * halves.lo;  // exact products, because c has only 4 bits
  const double sum = denominator + c * numerator;
  const double lost = (denominator - sum) + c * numerator;  // rounding error of `sum`
  const double t = rest / sum;
  const double square = t * t;
  const double series = t * square * polynomial(kArcTangent, square) - t * (lost / sum);
  const DoubleDouble& base = kArcTangentOfEighths[static_cast<std::size_t>(nearest > 0 ? nearest : 0)];
  const DoubleDouble leading = twoSum(base.hi, t);
  return quickTwoSum(leading.hi, leading.lo + (series + base.lo));
}

constexpr DoubleDouble kLn2{0.6931471805599453, 2.3190468138462996e-17};
constexpr double kSmallestExponent = -746;  // e^-746 is less than half the smallest subnormal

/// Number 2^exponent (hi + lo). Its significand hi + lo is between 0.7 and 1.42.
struct ScaledValue {
  DoubleDouble significand;
  int exponent = 0;
};

/// Returns e^x, accurate to 2^-60. For x above 2^30 the result is infinite or NaN. @pre x > -2^30.
ScaledValue scaledExponential(double x) {
  const double n = std::round(x / kLn2.hi);
  const DoubleDouble r = DoubleDouble(x) - kLn2 * DoubleDouble(n);
  const DoubleDouble square = twoProduct(r.hi, r.hi);
  const double tail = r.hi * square.hi * polynomial(kExponential, r.hi) + (0.5 * square.lo + r.hi * r.lo);
  const int exponent = static_cast<int>(n < 0x1p30 ? n : 0x1p30);
  return {DoubleDouble(1) + (r + (DoubleDouble(0.5 * square.hi) + tail)), exponent};
}

// Above this |u|, e^-2|u| is less than half an ulp of 1. Therefore tanh is 1, and sech is 2 e^-|u|.
constexpr double kTanhIsOne = 20;
// Below this |u|, sinh is computed as a series, because 1 - e^-2|u| would cancel.
constexpr double kSinhIsASeries = 0.25;

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
  if (size <= 1) return std::copysign(arcTangentOfFraction(size, 1).hi, x);
  // Beyond 2^60, the complement is less than half an ulp of pi/2. Splitting a huge `size` into halves would
  // overflow.
  const DoubleDouble complement = size > 0x1p60 ? DoubleDouble(0) : arcTangentOfFraction(1, size);
  return std::copysign((kHalfPi - complement).hi, x);
}

double arcTangentQuotient(double e) {
  constexpr double kSeriesEnds = 9.0 / 256;  // square of 3/16, the range of kArcTangent
  if (e <= kSeriesEnds) return 1 + e * polynomial(kArcTangent, e);
  const double root = std::sqrt(e);
  return arcTangent(root) / root;
}

double exponential(double x) {
  if (x < kSmallestExponent) return 0;
  const ScaledValue e = scaledExponential(x);
  return std::ldexp(e.significand.hi, e.exponent);
}

double exponentialLessOne(double x) {
  constexpr double kNothingLeft = -80;  // below this, e^x is less than half an ulp of 1
  if (x < kNothingLeft) return -1;
  const ScaledValue e = scaledExponential(x);
  return (scaled(e.significand, e.exponent) - DoubleDouble(1)).hi;
}

// Computes ln x = n ln 2 + 2 artanh t, where x = 2^n f, t = (f - 1)/(f + 1), and f is within a factor of sqrt 2 of
// 1.
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
  if (size > kTanhIsOne) return {std::copysign(1, u), 2 * exponential(-size)};
  const ScaledValue factor = scaledExponential(-size);
  const DoubleDouble e = scaled(factor.significand, factor.exponent), square = e * e;
  const DoubleDouble sech = e * 2.0 / (DoubleDouble(1) + square);
  if (size > kSinhIsASeries)
    return {std::copysign(((DoubleDouble(1) - square) / (DoubleDouble(1) + square)).hi, u), sech.hi};
  const DoubleDouble sinh = quickTwoSum(u, u * (u * u) * polynomial(kSinh, u * u));
  return {(sinh * sech).hi, sech.hi};
}

}  // namespace poinsot::physics
