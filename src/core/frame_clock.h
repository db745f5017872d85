// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/rational.h"

namespace poinsot::core {

/// Returns the film time of frame `k` in s: k * den / num, rounded once, so that errors do not accumulate.
double filmTime_s(std::int64_t k, const Rational& fps);

/// Returns the number of frames of a film: the number of k >= 0 with k / fps < duration, computed in integers. The
/// duration is taken as the shortest decimal that reads back as the same double, which is what its author wrote.
/// For example, 0.1 s at 30 fps are 3 frames, although the double is slightly above 1/10.
/// @pre duration_s > 0 and finite, at most 10^9; both parts of fps at most 10^9.
std::int64_t frameCount(double duration_s, const Rational& fps);

}  // namespace poinsot::core
