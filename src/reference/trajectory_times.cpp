// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/frame_clock.h"

namespace poinsot::reference {
namespace {

constexpr double kExactIntegers = 0x1p53;  // every integer up to it is a double

/// How many k >= 0 have k / rate <= span. Four roundings are forgiven: speed times duration, times the rate.
std::int64_t countWithin(double span_s, const core::Rational& rate_hz) {
  const double last = std::floor(std::abs(span_s) * rate_hz.value() * (1 + 0x1p-50));
  if (!(last * static_cast<double>(rate_hz.den) < kExactIntegers))
    throw core::Error(
        core::ErrorKind::kLimit,
        fmt::format("--rate {}: {:.3g} rows are more than can be told apart", core::toString(rate_hz), last));
  return static_cast<std::int64_t>(last) + 1;
}

}  // namespace

TrajectoryTimes::TrajectoryTimes(std::vector<double> listed_s)
    : listed_s_(std::move(listed_s)), count_(static_cast<std::int64_t>(listed_s_.size())) {
  if (listed_s_.empty()) throw core::Error(core::ErrorKind::kUsage, "no times are given");
  for (const double t_s : listed_s_)
    if (!std::isfinite(t_s)) throw core::Error(core::ErrorKind::kUsage, fmt::format("no motion time: {}", t_s));
  const auto [least, largest] = std::minmax_element(listed_s_.begin(), listed_s_.end());
  earliest_s_ = *least;
  latest_s_ = *largest;
}

TrajectoryTimes::TrajectoryTimes(const core::Rational& rate_hz, double start_s, double span_s)
    : rate_hz_(rate_hz), start_s_(start_s), direction_(span_s < 0 ? -1 : 1), count_(countWithin(span_s, rate_hz)) {
  std::tie(earliest_s_, latest_s_) = std::minmax((*this)[0], (*this)[count_ - 1]);
}

double TrajectoryTimes::operator[](std::int64_t k) const {
  if (!listed_s_.empty()) return listed_s_[static_cast<std::size_t>(k)];
  return start_s_ + direction_ * core::filmTime_s(k, rate_hz_);
}

}  // namespace poinsot::reference
