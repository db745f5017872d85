// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace poinsot::stage {

/// Ticks of an axis, at whole multiples of 1, 2 or 5 times a power of ten.
struct Ticks {
  int digit = 1;
  int power = 0;                     ///< the step is digit * 10^power
  std::int64_t first = 0, last = 0;  ///< multiples of the step, both included

  int count() const { return static_cast<int>(last - first) + 1; }
  double step() const;
  double at(std::int64_t multiple) const;
  /// Returns the number of decimals that write every multiple of the step exactly.
  int decimals() const { return power < 0 ? -power : 0; }
};

/// Returns the finest ticks, at most `most` of them (4 to 9 for most = 9), with the first at or below `low` and
/// the last at or above `high`. @pre low < high, both finite; most >= 7.
Ticks coveringTicks(double low, double high, int most = 9);

/// Returns the finest ticks between `low` and `high`, at most `most` of them; rarely fewer than 4, at least 1.
/// @pre low < high, both finite; most >= 3.
Ticks innerTicks(double low, double high, int most = 9);

/// Returns the exact decimal digits of a multiple of the step, for example "-0.15".
std::string tickDigits(const Ticks& ticks, std::int64_t multiple);

}  // namespace poinsot::stage
