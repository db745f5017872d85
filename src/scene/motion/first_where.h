// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numeric>

namespace poinsot::scene {

/// Returns the first number from `low` to `high` at which a condition holds, to the last bit. The condition must
/// hold at `high`, and at every number above one at which it holds.
template <class Condition>
double firstWhere(const Condition& holds, double low, double high) {
  if (holds(low)) return low;
  for (;;) {
    const double middle = std::midpoint(low, high);
    if (middle <= low || middle >= high) return high;
    (holds(middle) ? high : low) = middle;
  }
}

}  // namespace poinsot::scene
