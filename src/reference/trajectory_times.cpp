// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_times.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/frame_clock.h"
#include "physics/motion.h"
#include "physics/run_condition.h"

namespace poinsot::reference {

namespace {

constexpr double kExactIntegers = 0x1p53;  // largest range in which every integer is a double

/// Returns the number of k >= 0 with k / rate <= span. Includes a last k that exceeds the span only by rounding.
std::int64_t countWithin(double span_s, const core::Rational& rate_hz) {
  const double last = std::floor(std::abs(span_s) * rate_hz.value() * (1 + 0x1p-50));
  if (!(last * static_cast<double>(rate_hz.den) < kExactIntegers))
    throw core::limitError(
        fmt::format("--rate {}: the times of {:.3g} rows cannot be distinguished; lower the rate",
                    core::toString(rate_hz), last));
  return static_cast<std::int64_t>(last) + 1;
}

}  // namespace

TrajectoryTimes::TrajectoryTimes(std::vector<double> listed_s)
    : listed_s_(std::move(listed_s)), count_(static_cast<std::int64_t>(listed_s_.size())) {
  if (listed_s_.empty()) throw core::usageError("no times are given");
  for (const double t_s : listed_s_)
    if (!std::isfinite(t_s)) throw core::usageError(fmt::format("{} is not a motion time", t_s));
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

namespace {

constexpr double kRounding = 0x1p-52;  // relative rounding error of an input

/// Uncertainty of the attitude after a rotation by kExactPhase_rad, caused by rounding errors of omega.
constexpr double kUncertain_rad = kRounding * physics::kExactPhase_rad;

/// Rotation angle after which rounding errors of omega change the attitude by one radian: 4.5e15 rad.
constexpr double kLastPhase_rad = 1 / kRounding;

/// Ratio above which the note names the separatrix as the cause: uncertainty of the attitude, divided by the part
/// that comes from the rounding of omega alone. Far from the separatrix, the ratio is about 3, for example 3.3 for
/// moments (1, 2, 3) and omega (1, 1, 1).
constexpr double kCloseToSeparatrix = 100;

std::string farTurnNote(double t_s, double angle_rad) {
  const std::string turned = fmt::format("at t = {:.6g} s the body has turned by {:.2g} rad; ", t_s, angle_rad);
  if (angle_rad < kLastPhase_rad)
    return turned +
           fmt::format("beyond {:.0g} rad the attitude is no longer exact to rounding", physics::kExactPhase_rad);
  return turned + fmt::format(
                      "beyond {:.2g} rad the attitude is meaningless, because the rounding of omega alone "
                      "turns the body by more than a radian",
                      kLastPhase_rad);
}

std::string uncertaintyNote(double t_s, double angle_rad, const physics::RunCondition& condition) {
  const bool close = condition.attitude_rad > kCloseToSeparatrix * kRounding * (1 + angle_rad);
  return fmt::format(
      "at t = {:.6g} s the attitude is uncertain by {:.2g} rad if the input is rounded: {}, and {} "
      "of the attitude is meaningful",
      t_s, condition.attitude_rad,
      close ? "the motion is close to the separatrix" : "the run amplifies the rounding",
      condition.digits < 1 ? "no digit" : "one digit");
}

}  // namespace

std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times) {
  if (!scene.motion.isFree()) return {};
  const double farthest_s = std::max(std::abs(times.earliest_s()), std::abs(times.latest_s()));
  const double angle_rad = scene.motion.omega_B.norm() * farthest_s;
  if (angle_rad > physics::kExactPhase_rad) return farTurnNote(farthest_s, angle_rad);
  const physics::RunCondition condition = physics::runCondition(scene.body.axes, scene.motion.omega_B, farthest_s);
  if (!(condition.attitude_rad > kUncertain_rad)) return {};
  return uncertaintyNote(farthest_s, angle_rad, condition);
}

}  // namespace poinsot::reference
