// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_ticks.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "core/expect.h"

namespace poinsot::stage {
namespace {

// Tolerance for rounding, as a fraction of a step. An end of the range that is this near to a tick counts as on
// the tick.
constexpr double kOnTick = 1e-9;

Ticks covering(double low, double high, Ticks ticks) {
  ticks.first = static_cast<std::int64_t>(std::floor(low / ticks.step() + kOnTick));
  ticks.last = static_cast<std::int64_t>(std::ceil(high / ticks.step() - kOnTick));
  return ticks;
}

Ticks inner(double low, double high, Ticks ticks) {
  ticks.first = static_cast<std::int64_t>(std::ceil(low / ticks.step() - kOnTick));
  ticks.last = static_cast<std::int64_t>(std::floor(high / ticks.step() + kOnTick));
  return ticks;
}

/// Returns the next coarser step: 1, 2, 5, 10, 20, ...
Ticks coarser(Ticks ticks) {
  if (ticks.digit == 5) return {.digit = 1, .power = ticks.power + 1};
  return {.digit = ticks.digit == 1 ? 2 : 5, .power = ticks.power};
}

template <class Placed>
Ticks finest(double low, double high, int most, Placed placed) {
  POINSOT_EXPECT(low < high && std::isfinite(low) && std::isfinite(high));
  // The first step is at most a hundredth of the length, which gives too many ticks for every `most`.
  Ticks ticks{.digit = 1, .power = static_cast<int>(std::floor(std::log10(high - low))) - 2};
  while (placed(low, high, ticks).count() > most) ticks = coarser(ticks);
  return placed(low, high, ticks);
}

}  // namespace

double Ticks::step() const { return at(1); }

double Ticks::at(std::int64_t multiple) const {
  const auto whole = static_cast<double>(multiple * digit);
  // Division by a power of ten rounds only once, so 3 tenths give the double nearest to 0.3.
  return power < 0 ? whole / std::pow(10.0, -power) : whole * std::pow(10.0, power);
}

Ticks coveringTicks(double low, double high, int most) {
  POINSOT_EXPECT(most >= 7);
  return finest(low, high, most, covering);
}

Ticks innerTicks(double low, double high, int most) {
  POINSOT_EXPECT(most >= 3);
  return finest(low, high, most, inner);
}

std::string tickDigits(const Ticks& ticks, std::int64_t multiple) {
  const std::int64_t whole = multiple * ticks.digit;
  std::string digits = fmt::format("{}", std::abs(whole));
  if (ticks.power > 0 && whole != 0) digits.append(static_cast<std::size_t>(ticks.power), '0');
  if (const auto decimals = static_cast<std::size_t>(ticks.decimals()); decimals > 0) {
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, 1, '.');
  }
  return whole < 0 ? "-" + digits : digits;
}

}  // namespace poinsot::stage
