// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

namespace poinsot {

/// Returns 41 times: from the smallest double to the largest, infinity and NaN, of both signs.
inline std::vector<double> extremeTimes() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> all{Limits::quiet_NaN()};
  for (const double t : {0.0,           Limits::denorm_min(),
                         Limits::min(), 1e-300,
                         1e-20,         0.7,
                         1e14,          0x1p53,
                         1e18,          1e100,
                         1e154,         1e289,
                         1e290,         1e291,
                         0x1p996,       1e300,
                         1e307,         1e308,
                         Limits::max(), Limits::infinity()})
    all.insert(all.end(), {t, -t});
  return all;
}

}  // namespace poinsot
