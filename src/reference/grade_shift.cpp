// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_shift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/number.h"

namespace poinsot::reference {
namespace {

using Eigen::Vector3d;
using physics::Quaternion;
using physics::RigidBodyState;

constexpr double kStep_rad = 0.1;       // step of the search, smaller than the width of a minimum
constexpr double kReach_rad = 1000;     // largest shift to search, to either side
constexpr double kLeastReach_rad = 20;  // shift to search for a short log: three turns
constexpr double kNear_rad = 0.3;       // largest distance between the first row and a candidate
constexpr double kClock_s = 1e8;        // three years; a larger shift suggests calendar time
constexpr std::size_t kProbeRows = 16;  // rows for the first check of a candidate
constexpr double kUnlike = 0.5;         // rms over these rows, rad or relative; larger: discarded
constexpr std::size_t kFewCandidates = 24;
constexpr double kEqualMeans = 4;  // two mean squares within this factor count as equal
constexpr double kNoise = 1e-20;   // mean square of rounding errors
constexpr int kRounds = 30;        // limit on the iterations of the fit; about five are needed

/// Returns the differences between a row and a state: attitude (rotation vector, rad) and omega (relative to
/// `scale`).
std::array<Vector3d, 3> differences(const LoggedState& theirs, const RigidBodyState& ours, double scale) {
  std::array<Vector3d, 3> d{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  if (theirs.q_WB) {
    const Quaternion turn = ours.q_WB.conjugate() * *theirs.q_WB;
    const double size = turn.vec().norm();
    if (size > 0) d[0] = turn.vec() * (2 * std::atan2(size, std::abs(turn.w())) / (turn.w() < 0 ? -size : size));
  }
  if (theirs.omega_B) d[1] = (*theirs.omega_B - ours.omega_B) / scale;
  if (theirs.omega_W) d[2] = (*theirs.omega_W - ours.omega_W) / scale;
  return d;
}

double squared(const std::array<Vector3d, 3>& d) {
  return d[0].squaredNorm() + d[1].squaredNorm() + d[2].squaredNorm();
}

/// Returns the decimal number with the fewest digits that differs from `value` by at most `tolerance`.
double shortestNear(double value, double tolerance) {
  for (int digits = 1; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    const double rounded = *core::parseNumber(fmt::format("{:.{}g}", value, digits));
    if (std::abs(rounded - value) <= tolerance) return rounded;
  }
  return value;
}

struct Candidate {
  double shift_s = 0;
  double mean = 0;  ///< mean square of the differences between log and motion
};

class ShiftSearch {
 public:
  ShiftSearch(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span)
      : motion_(motion), maker_(maker), span_(span) {}

  std::optional<Reading> reading(const LogSample& sample);

 private:
  void prepare(const LogSample& sample);
  void scan(const physics::TimeSpan& starts);
  std::optional<double> bestShift(const LogSample& sample) const;
  std::vector<double> likelyShifts(const LogSample& sample) const;
  double meanOver(const LogSample& sample, double shift_s, std::size_t rows) const;
  double fitted(const LogSample& sample, double shift_s) const;
  bool knows(const LogSample& sample, double shift_s) const;

  KnownMotion& motion_;
  const MotionMaker& maker_;
  physics::TimeSpan span_;
  bool prepared_ = false;
  double scale_ = 0, step_s_ = 0;
  std::vector<std::vector<RigidBodyState>> scans_;  // states of the motion to compare with the first row
};

/// Computes the motion at possible times of the first row: near the time in the log, and near 0.
void ShiftSearch::prepare(const LogSample& sample) {
  prepared_ = true;
  if (!maker_) return;
  const double length_s = span_.to_s - span_.from_s;
  scale_ = largestOmega(sample);
  if (motion_.extend(maker_, {0, length_s}))  // at t = 0, before dissipation, the body is fastest
    scale_ = std::max(scale_, motion_.at(0).omega_B.norm());
  if (!(scale_ > 0)) return;
  step_s_ = kStep_rad / scale_;
  const double reach_s = std::clamp(length_s, kLeastReach_rad / scale_, kReach_rad / scale_);
  const double first_s = sample.theirs.front().t_s;
  if (std::abs(first_s) <= 2 * reach_s) {
    scan({std::min(0., first_s) - reach_s, std::max(0., first_s) + reach_s});
    return;
  }
  scan({-reach_s, reach_s});
  scan({first_s - reach_s, first_s + reach_s});
}

/// Computes the motion at possible start times. Begins at 0 if the dissipation cannot be followed backwards.
void ShiftSearch::scan(const physics::TimeSpan& starts) {
  double from_s = starts.from_s;
  const double end_s = starts.to_s + span_.to_s - span_.from_s;
  if (!motion_.extend(maker_, {from_s, end_s})) {
    from_s = std::max(0., from_s);
    if (!(from_s < starts.to_s) || !motion_.extend(maker_, {from_s, end_s})) return;
  }
  std::vector<RigidBodyState>& states = scans_.emplace_back();
  const auto count = static_cast<std::size_t>((starts.to_s - from_s) / step_s_);  // at most 40 000
  for (std::size_t k = 0; k < count; ++k) states.push_back(motion_.at(from_s + static_cast<double>(k) * step_s_));
}

/// Returns the shifts for which the motion is closest to the first row.
std::vector<double> ShiftSearch::likelyShifts(const LogSample& sample) const {
  const LoggedState& first = sample.theirs.front();
  std::vector<double> shifts;
  for (const auto& states : scans_) {
    std::vector<double> distances;
    for (const RigidBodyState& state : states) distances.push_back(squared(differences(first, state, scale_)));
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const bool lowest = (i == 0 || distances[i] <= distances[i - 1]) &&
                          (i + 1 == distances.size() || distances[i] <= distances[i + 1]);
      if (lowest && distances[i] < kNear_rad * kNear_rad) shifts.push_back(states[i].t_s - first.t_s);
    }
  }
  return shifts;
}

bool ShiftSearch::knows(const LogSample& sample, double shift_s) const {
  return std::ranges::all_of(sample.theirs, [&](const LoggedState& s) { return motion_.knows(s.t_s + shift_s); });
}

double ShiftSearch::meanOver(const LogSample& sample, double shift_s, std::size_t rows) const {
  const std::size_t stride = std::max<std::size_t>(1, sample.theirs.size() / rows);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < sample.theirs.size(); i += stride, ++count)
    sum += squared(differences(sample.theirs[i], motion_.at(sample.theirs[i].t_s + shift_s), scale_));
  return sum / count;
}

/// Fits the shift to all rows with the Gauss-Newton method. Derivatives are central differences.
double ShiftSearch::fitted(const LogSample& sample, double shift_s) const {
  const double h_s = 1e-4 / scale_;
  for (int round = 0; round < kRounds; ++round) {
    if (!knows(sample, shift_s - h_s) || !knows(sample, shift_s + h_s)) break;
    double along = 0, slopes = 0;
    for (const LoggedState& theirs : sample.theirs) {
      const double t_s = theirs.t_s + shift_s;
      const auto d = differences(theirs, motion_.at(t_s), scale_);
      const auto before = differences(theirs, motion_.at(t_s - h_s), scale_);
      const auto after = differences(theirs, motion_.at(t_s + h_s), scale_);
      for (std::size_t i = 0; i < d.size(); ++i) {
        const Vector3d slope = (after[i] - before[i]) / (2 * h_s);
        along += slope.dot(d[i]);
        slopes += slope.squaredNorm();
      }
    }
    if (!(slopes > 0)) break;
    const double change_s = std::clamp(-along / slopes, -step_s_, step_s_);
    shift_s += change_s;
    if (std::abs(change_s) * scale_ < 1e-14) break;
  }
  return shift_s;
}

std::string shiftRemark(double shift_s, double first_s) {
  return fmt::format("{}t {} {}; the first row is the motion at {:.6g} s",
                     std::abs(shift_s) > kClock_s ? "a clock's time: " : "", shift_s < 0 ? '-' : '+',
                     std::abs(shift_s), first_s + shift_s);
}

/// Returns the shift that fits best. If several fit equally well, returns the smallest.
std::optional<double> ShiftSearch::bestShift(const LogSample& sample) const {
  std::vector<Candidate> candidates;
  for (const double shift_s : likelyShifts(sample)) {
    if (!knows(sample, shift_s)) continue;
    const Candidate candidate{shift_s, meanOver(sample, shift_s, kProbeRows)};
    if (candidate.mean < kUnlike * kUnlike) candidates.push_back(candidate);
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::mean);
  if (candidates.size() > kFewCandidates) candidates.resize(kFewCandidates);
  std::optional<Candidate> best;
  for (Candidate& candidate : candidates) {
    candidate.shift_s = fitted(sample, candidate.shift_s);
    if (!knows(sample, candidate.shift_s)) continue;
    candidate.mean = meanOver(sample, candidate.shift_s, sample.theirs.size()) + kNoise;
    const bool nearer = best && std::abs(candidate.shift_s) < std::abs(best->shift_s);
    if (!best || candidate.mean < best->mean * (nearer ? kEqualMeans : 1 / kEqualMeans)) best = candidate;
  }
  return best ? std::optional(best->shift_s) : std::nullopt;
}

std::optional<Reading> ShiftSearch::reading(const LogSample& sample) {
  if (!prepared_) prepare(sample);
  const auto exact_s = bestShift(sample);
  if (!exact_s) return std::nullopt;
  const std::size_t rows = sample.theirs.size();
  const double rms = std::sqrt(meanOver(sample, *exact_s, rows));
  const double shift_s = shortestNear(*exact_s, std::max(3 * rms, 1e-12) / scale_);
  if (shift_s == 0) return std::nullopt;
  return shiftReading(shift_s, sample.theirs.front().t_s);
}

}  // namespace

Reading shiftReading(double shift_s, double first_s) {
  const auto shifted = [shift_s](LoggedState s) {
    s.t_s += shift_s;
    return s;
  };
  return {Aspect::kShift,
          {fmt::format("t is {} s {}", std::abs(shift_s), shift_s < 0 ? "earlier" : "later"),
           shiftRemark(shift_s, first_s)},
          shifted};
}

Hypothesis shiftHypothesis(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span) {
  const auto search = std::make_shared<ShiftSearch>(motion, maker, span);
  return {Aspect::kShift, [search](const LogSample& sample) { return search->reading(sample); }};
}

}  // namespace poinsot::reference
