// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/rational.h"

namespace poinsot::core {

/// Film time of frame k in s: k * den / num, rounded once; nothing accumulates.
double filmTime_s(std::int64_t k, const Rational& fps);

/// How many frames a film of `duration_s` has: the number of k >= 0 with k / fps < duration, in integers.
/// The duration is taken as the shortest decimal number that reads back as this double, which is what its author
/// wrote: 0.1 s at 30 fps are 3 frames, although the double lies a little above 1/10.
/// @pre duration_s > 0 and finite, at most 10^9; both parts of fps at most 10^9.
std::int64_t frameCount(double duration_s, const Rational& fps);

}  // namespace poinsot::core
