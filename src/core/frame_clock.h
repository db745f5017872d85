// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/rational.h"

namespace poinsot::core {

/// Returns the film time of frame `k` in s: k * den / num. Rounded once, so errors do not accumulate.
double filmTime_s(std::int64_t k, const Rational& fps);

/// Returns the number of frames of a film: the number of k >= 0 with k / fps < duration. Computes with the
/// shortest decimal that reads back as `duration_s`, because that is the number in the scene file. For example,
/// 0.1 s at 30 fps are 3 frames, although the double 0.1 is slightly above 1/10.
/// @pre duration_s > 0 and finite, at most 10^9; both parts of fps at most 10^9.
std::int64_t frameCount(double duration_s, const Rational& fps);

}  // namespace poinsot::core
