// SPDX-License-Identifier: Apache-2.0
// Cube root and power without branches and calls, so that compilers vectorise the loops that use them. The results
// have the same bits in a vector unit and outside.
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

namespace poinsot::compare {

/// Returns the cube root of a positive number to two units in the last place. The first guess divides the exponent
/// by -3 and is within 6 %. Each step for the inverse root cubes the relative error, without a division.
[[gnu::always_inline]] inline double cubeRoot(double t) {
  constexpr std::uint64_t kGuess = 0x553EF0FF, kThird = 0x55555556;  // of the upper 32 bits, and of 2^32
  const std::uint64_t upper = std::bit_cast<std::uint64_t>(t) >> 32;
  double inverse = std::bit_cast<double>((kGuess - (upper * kThird >> 32)) << 32);
  for (int step = 0; step < 3; ++step) {
    const double error = 1 - t * inverse * inverse * inverse;
    inverse += inverse * error * (1.0 / 3 + 2.0 / 9 * error);
  }
  const double square = inverse * inverse, root = t * square;
  return root - (root * root * root - t) * square * (1.0 / 3);
}

/// Returns the binary logarithm of a positive normal number.
[[gnu::always_inline]] inline double binaryLogarithm(double x) {
  constexpr std::uint64_t kMantissa = 0x000FFFFFFFFFFFFF, kOne = 0x3FF0000000000000,
                          kRootHalf = 0x3FE6A09E667F3BCD;
  // x = 2^k m with m from √½ to √2. An integer below 2^52 becomes a double by the bits of 2^52 before it.
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + (kOne - kRootHalf);
  const double k = std::bit_cast<double>(0x4330000000000000 | bits >> 52) - (0x1p52 + 1023);
  const double m = std::bit_cast<double>((bits & kMantissa) + kRootHalf);
  // ln m = 2 artanh s, as a series in s, which is at most 0.172.
  const double s = (m - 1) / (m + 1), z = s * s;
  double sum = 1.0 / 21;
  sum = sum * z + 1.0 / 19;
  sum = sum * z + 1.0 / 17;
  sum = sum * z + 1.0 / 15;
  sum = sum * z + 1.0 / 13;
  sum = sum * z + 1.0 / 11;
  sum = sum * z + 1.0 / 9;
  sum = sum * z + 1.0 / 7;
  sum = sum * z + 1.0 / 5;
  sum = sum * z + 1.0 / 3;
  return k + (2 * std::numbers::log2e) * (s + s * (z * sum));
}

/// Returns 2^t for t from -1000 to 1000.
[[gnu::always_inline]] inline double powerOfTwo(double t) {
  // Adding 1.5 · 2^52 rounds t to an integer, which is then in the last bits.
  constexpr double kRounding = 0x1.8p52;
  const double shifted = t + kRounding, u = (t - (shifted - kRounding)) * std::numbers::ln2;
  double sum = 1.0 / 6227020800;  // Taylor series of e^u up to u^13/13!; |u| is at most 0.347
  sum = sum * u + 1.0 / 479001600;
  sum = sum * u + 1.0 / 39916800;
  sum = sum * u + 1.0 / 3628800;
  sum = sum * u + 1.0 / 362880;
  sum = sum * u + 1.0 / 40320;
  sum = sum * u + 1.0 / 5040;
  sum = sum * u + 1.0 / 720;
  sum = sum * u + 1.0 / 120;
  sum = sum * u + 1.0 / 24;
  sum = sum * u + 1.0 / 6;
  sum = sum * u + 1.0 / 2;
  const double root = 1 + (u + u * u * sum);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(root) + (std::bit_cast<std::uint64_t>(shifted) << 52));
}

/// Returns x^y for a positive normal x and |y log2 x| up to 1000.
[[gnu::always_inline]] inline double power(double x, double y) { return powerOfTwo(y * binaryLogarithm(x)); }

}  // namespace poinsot::compare
