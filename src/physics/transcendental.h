// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/double_double.h"

namespace poinsot::physics {

// Transcendental functions that give the same bits on every machine, because they use only + - * / and sqrt. The C
// library chooses its code by the CPU, so that the last bit may differ. The functions are accurate to 1 ulp
// (measured in tests/physics/transcendental_test.cpp). A NaN argument gives a NaN, by which the integrator detects
// a step that is too long.

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Returns sine and cosine of an angle in rad, accurate to 1 ulp. Where the result is near 0, the accuracy is
/// 2^-103 of the angle.
/// @pre |angle| < 2^53.
SineCosine sineCosine(const DoubleDouble& angle);

/// Returns the arctangent in rad, within [-pi/2, pi/2]; atan(+-inf) = +-pi/2.
double arcTangent(double x);

inline constexpr double kLargestExponent = 700;

/// Returns atan(sqrt e)/sqrt e, which is Carlson's R_C(1, 1 + e). For e = 0 the result is 1. The error is at most
/// 2 ulp.
/// @pre e >= 0.
double arcTangentQuotient(double e);

/// Returns e^x, or 0 if e^x is below the smallest double. @pre x <= kLargestExponent.
double exponential(double x);

/// Returns e^x - 1, accurate even for x near 0. @pre x <= kLargestExponent.
double exponentialLessOne(double x);

/// Returns ln x. @pre x > 0.
double logarithm(double x);

/// Values of tanh u and sech u = 1/cosh u, consistent with each other. sech may underflow to 0; nothing overflows.
struct HyperbolicPair {
  double tanh = 0;
  double sech = 1;
};
HyperbolicPair hyperbolicPair(double u);

}  // namespace poinsot::physics
