// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/rational.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// Motion times in s for the rows of a trajectory. Times at a constant rate are computed, not stored.
class TrajectoryTimes {
 public:
  /// Keeps a list of times, in the given order, with repetitions. @throws core::Error(kUsage) if the list is
  /// empty, or if a time is not finite.
  explicit TrajectoryTimes(std::vector<double> listed_s);

  /// Creates the times start + k/rate for k = 0, 1, ... over `span_s`, including the end if it is one of the
  /// times. If the span is negative, the times decrease. Each k/rate is rounded once, so that errors do not
  /// accumulate. A last time that exceeds the end only by rounding is included.
  /// @throws core::Error(kLimit) if there are too many times to be distinct.
  TrajectoryTimes(const core::Rational& rate_hz, double start_s, double span_s);

  std::int64_t count() const { return count_; }
  double operator[](std::int64_t k) const;

  double earliest_s() const { return earliest_s_; }
  double latest_s() const { return latest_s_; }

 private:
  std::vector<double> listed_s_;  // empty for times at a constant rate
  core::Rational rate_hz_;
  double start_s_ = 0;
  double direction_ = 1;
  std::int64_t count_ = 0;
  double earliest_s_ = 0, latest_s_ = 0;
};

/// Returns a warning if the attitude at the farthest time is uncertain by more than 0.02 rad. Reasons are: the
/// body has rotated so far that a double cannot represent the phase, or the motion amplifies rounding errors of
/// the input, mostly near the separatrix. Returns an empty text otherwise, and for a driven motion.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::reference
