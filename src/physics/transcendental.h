// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/double_double.h"

namespace poinsot::physics {

// The transcendental functions of the motion, from + - * / sqrt only. The C library's choose their code (and so
// their last bit) by the CPU they find; these give one trajectory on every machine. Within 1 ulp; the measured
// errors stand in tests/physics/transcendental_test.cpp. A NaN gives a NaN: that is how the
// integrator finds a step too long.

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Of an angle in radians: to 1 ulp, or, where the result is near 0, to 2^-103 of the angle. @pre |angle| < 2^53.
SineCosine sineCosine(const DoubleDouble& angle);

/// In radians, within [-pi/2, pi/2]; atan(+-inf) = +-pi/2.
double arcTangent(double x);

inline constexpr double kLargestExponent = 700;

/// atan(sqrt e)/sqrt e, which is R_C(1, 1 + e) of Carlson; 1 at 0. Within 2 ulp. @pre e >= 0.
double arcTangentQuotient(double e);

/// e^x; 0 below the smallest double. @pre x <= kLargestExponent.
double exponential(double x);

/// e^x - 1, all digits kept near 0. @pre x <= kLargestExponent.
double exponentialLessOne(double x);

/// ln x. @pre x > 0.
double logarithm(double x);

/// tanh u and sech u = 1/cosh u, consistent with each other; sech underflows to 0, nothing overflows.
struct HyperbolicPair {
  double tanh = 0;
  double sech = 1;
};
HyperbolicPair hyperbolicPair(double u);

}  // namespace poinsot::physics
