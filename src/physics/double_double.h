// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace poinsot::physics {

/// Number with about 106 significant bits, stored as the unevaluated sum hi + lo of two doubles with |lo| <=
/// ulp(hi)/2.
///
/// This precision is needed to reduce a phase of 1e14 rad modulo a turn, and to compute the distance to the
/// separatrix, which is a small difference. Only + - * / and sqrt of IEEE doubles are used, so that every CPU
/// computes the same bits. The relative error of each operation is below 2^-103 (measured in
/// tests/physics/double_double_test.cpp). Source: T. J. Dekker, Numer. Math. 18 (1971) 224 (products); Knuth,
/// TAOCP 2, 4.2.2 (sums).
struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  constexpr DoubleDouble() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): every double is one of these values, exactly.
  constexpr DoubleDouble(double value) : hi(value) {}
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
};

/// Returns a + b exactly.
constexpr DoubleDouble twoSum(double a, double b) {
  const double sum = a + b;
  const double bPart = sum - a;
  return {sum, (a - (sum - bPart)) + (b - bPart)};
}

/// Returns a + b exactly, for |a| >= |b| or a = 0.
constexpr DoubleDouble quickTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Splits a into its upper 26 bits (hi) and the rest (lo). @pre |a| < 2^996.
constexpr DoubleDouble splitInHalves(double a) {
  constexpr double kSplitter = 134217729;  // 2^27 + 1
  const double scaled = kSplitter * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// Returns a * b exactly, unless the error term underflows (|a b| < 2^-968). std::fma is not used, because it is a
/// slow library call on CPUs without this instruction. @pre |a|, |b| < 2^996.
constexpr DoubleDouble twoProduct(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = splitInHalves(a), y = splitInHalves(b);
  return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

constexpr double toDouble(double a) { return a; }
constexpr double toDouble(const DoubleDouble& a) { return a.hi; }

constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = twoSum(a.hi, b.hi);
  const DoubleDouble low = twoSum(a.lo, b.lo);
  const DoubleDouble sum = quickTwoSum(high.hi, high.lo + low.hi);
  return quickTwoSum(sum.hi, sum.lo + low.lo);
}

constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = twoProduct(a.hi, b.hi);
  return quickTwoSum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = a - b * DoubleDouble(first);
  const double second = rest.hi / b.hi;
  const double third = (rest - b * DoubleDouble(second)).hi / b.hi;
  const DoubleDouble quotient = quickTwoSum(first, second);
  return quotient + DoubleDouble(third);
}

constexpr DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) { return a = a + b; }
constexpr DoubleDouble& operator-=(DoubleDouble& a, const DoubleDouble& b) { return a = a - b; }
constexpr DoubleDouble& operator*=(DoubleDouble& a, const DoubleDouble& b) { return a = a * b; }
constexpr DoubleDouble& operator/=(DoubleDouble& a, const DoubleDouble& b) { return a = a / b; }

constexpr bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
constexpr bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
constexpr bool operator==(const DoubleDouble& a, const DoubleDouble& b) { return a.hi == b.hi && a.lo == b.lo; }

constexpr DoubleDouble abs(const DoubleDouble& a) { return a.hi < 0 ? -a : a; }

/// Returns the square root. @pre a >= 0.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (a.hi == 0) return {};
  // One Newton step squares the relative error of the double root, which is 2^-53.
  const double root = std::sqrt(a.hi);
  const DoubleDouble rest = a - twoProduct(root, root);
  return quickTwoSum(root, rest.hi / (2 * root));
}

/// Returns the exponent e of x = m 2^e with 1/2 <= |m| < 1, or 0 for x = 0.
inline int exponentOf(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

inline DoubleDouble scaled(const DoubleDouble& a, int exponent) {
  return {std::ldexp(a.hi, exponent), std::ldexp(a.lo, exponent)};
}

inline constexpr DoubleDouble kPi{3.141592653589793, 1.2246467991473532e-16};
inline constexpr DoubleDouble kTwoPi{2 * kPi.hi, 2 * kPi.lo};
inline constexpr DoubleDouble kHalfPi{kPi.hi / 2, kPi.lo / 2};

/// Result of reduced(): a number minus the nearest multiple of a period. `multiple` is the number of subtracted
/// periods, which is exact below 2^53.
struct Reduced {
  DoubleDouble rest;
  double multiple = 0;
};

/// Subtracts the nearest multiple of `period` from x. If |x| is more than 2^100 periods, the rest is still in
/// range but has no correct digits.
/// @pre period > 0, x finite.
inline Reduced reduced(DoubleDouble x, const DoubleDouble& period) {
  double multiple = std::round(x.hi / period.hi);
  double total = multiple;
  x -= period * DoubleDouble(multiple);
  // A multiple above 2^53 is rounded, so that the rest may need further rounds. Each round removes about 50 of at
  // most 1100 bits.
  for (int round = 0; round < 24 && std::abs(x.hi) > 0.5000001 * period.hi; ++round) {
    multiple = std::round(x.hi / period.hi);
    total += multiple;
    x -= period * DoubleDouble(multiple);
  }
  return {x, total};
}

}  // namespace poinsot::physics
