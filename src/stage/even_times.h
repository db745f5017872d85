// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace poinsot::stage {

/// Returns `from_s`, the multiples of `step_s` in between, and `to_s`. The inner times are the same for every
/// picture, so that a curve through them does not shimmer.
/// @param most  maximum number of times; also ends the loop if the times are too large for `step_s` to change them
inline std::vector<double> evenTimes(double from_s, double to_s, double step_s, std::size_t most) {
  std::vector<double> times_s{from_s};
  const double last = std::ceil(to_s / step_s);
  for (double k = std::floor(from_s / step_s) + 1; k < last && times_s.size() + 1 < most; ++k)
    times_s.push_back(k * step_s);
  times_s.push_back(to_s);
  return times_s;
}

}  // namespace poinsot::stage
