// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_axis.h"

#include <algorithm>
#include <cmath>

namespace poinsot::stage {
namespace {

constexpr double kRangeRoom = 0.03;  // room beyond each end of the range, as a fraction of the range's length
constexpr double kFromZero = 0.3;    // a low end below this fraction of the high end is moved to zero
constexpr int kMostTicks = 7;
// Shortest length of a time axis, as a fraction of its times. On a shorter axis, doubles could not distinguish the
// ticks.
constexpr double kTold = 0x1p-40;

struct Span {
  double low, high;
};

Span constantSpan(double value, double size) {
  if (std::abs(value) < 0.5 * size) return {-size, size};  // zero up to rounding errors
  return value > 0 ? Span{0, 1.25 * value} : Span{1.25 * value, 0};
}

Span shownSpan(const QuantityRange& range) {
  const double length = range.high - range.low;
  if (!varies(range)) return constantSpan(0.5 * (range.low + range.high), sizeOf(range));
  Span span{range.low - kRangeRoom * length, range.high + kRangeRoom * length};
  if (range.low >= 0 && range.low < kFromZero * range.high) span.low = 0;
  if (range.high <= 0 && range.high > kFromZero * range.low) span.high = 0;
  return span;
}

double largest(const Span& span) { return std::max(std::abs(span.low), std::abs(span.high)); }

}  // namespace

PlotAxis valueAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked) {
  const Span span = shownSpan(range);
  PlotAxis axis;
  axis.unit = writtenUnit(unit, largest(span), asked);
  axis.ticks = coveringTicks(axis.unit.written(span.low), axis.unit.written(span.high), kMostTicks);
  axis.low = axis.ticks.at(axis.ticks.first);
  axis.high = axis.ticks.at(axis.ticks.last);
  axis.label = axisLabel(tex, axis.unit);
  return axis;
}

PlotAxis givenAxis(scene::QuantityUnit unit, const QuantityRange& range, const std::string& tex,
                   const std::string& asked, double low, double high) {
  PlotAxis axis = valueAxis(unit, range, tex, asked);
  axis.low = low;
  axis.high = high;
  axis.ticks = innerTicks(low, high, kMostTicks);
  return axis;
}

PlotAxis timeAxis(double from_s, double to_s, const std::string& tex) {
  auto [low_s, high_s] = std::minmax({from_s, to_s});
  // The axis would be too short: the motion time does not advance, or it is so large that doubles hardly resolve
  // it.
  const double told_s = std::abs(low_s) * kTold;
  if (high_s - low_s <= told_s) high_s = low_s + std::max(1.0, told_s);
  PlotAxis axis;
  axis.unit = writtenUnit(scene::QuantityUnit::kSecond, high_s - low_s);
  axis.low = axis.unit.written(low_s);
  axis.high = axis.unit.written(high_s);
  axis.ticks = innerTicks(axis.low, axis.high, 9);
  axis.label = axisLabel(tex, axis.unit);
  return axis;
}

PlotAxis withFewerTicks(const PlotAxis& axis, int most) {
  if (axis.ticks.count() <= most) return axis;
  PlotAxis fewer = axis;
  fewer.ticks = innerTicks(axis.low, axis.high, std::max(most, 3));
  return fewer;
}

}  // namespace poinsot::stage
