// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace poinsot::stage {

/// Ticks of an axis, at integer multiples of a step. The step is 1, 2 or 5 times a power of ten.
struct Ticks {
  int digit = 1;
  int power = 0;                     ///< the step is digit * 10^power
  std::int64_t first = 0, last = 0;  ///< first and last tick, as multiples of the step

  int count() const { return static_cast<int>(last - first) + 1; }
  double step() const;
  double at(std::int64_t multiple) const;
  /// Returns the number of decimals needed to write every multiple of the step exactly.
  int decimals() const { return power < 0 ? -power : 0; }
};

/// Returns ticks that cover a range: the first is at or below `low`, the last at or above `high`. The step is the
/// smallest that gives at most `most` ticks (4 to 9 ticks for most = 9). @pre low < high, both finite; most >= 7.
Ticks coveringTicks(double low, double high, int most = 9);

/// Returns the ticks between `low` and `high`. The step is the smallest that gives at most `most` ticks. There is
/// at least one tick, and there are rarely fewer than 4.
/// @pre low < high, both finite; most >= 3.
Ticks innerTicks(double low, double high, int most = 9);

/// Returns the exact decimal digits of a multiple of the step, such as "-0.15".
std::string tickDigits(const Ticks& ticks, std::int64_t multiple);

}  // namespace poinsot::stage
