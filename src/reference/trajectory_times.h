// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/rational.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// Motion times of a trajectory's rows, in order, in s. Times by a rate take no memory.
class TrajectoryTimes {
 public:
  /// Takes a list in any order, repeated or not. @throws core::Error(kUsage) for an empty list or a time not
  /// finite.
  explicit TrajectoryTimes(std::vector<double> listed_s);

  /// Makes the times start + k/rate for k = 0, 1, ... within `span_s`, both ends included if they are hit;
  /// backwards if the span is negative. Each k/rate is rounded once, so that errors do not accumulate. A last time
  /// beyond the end by no more than the rounding of the span is included.
  /// @throws core::Error(kLimit) if there are too many times to be distinct.
  TrajectoryTimes(const core::Rational& rate_hz, double start_s, double span_s);

  std::int64_t count() const { return count_; }
  double operator[](std::int64_t k) const;

  double earliest_s() const { return earliest_s_; }
  double latest_s() const { return latest_s_; }

 private:
  std::vector<double> listed_s_;  // empty if the times have a rate
  core::Rational rate_hz_;
  double start_s_ = 0;
  double direction_ = 1;
  std::int64_t count_ = 0;
  double earliest_s_ = 0, latest_s_ = 0;
};

/// Returns a sentence if the attitude at the farthest time is uncertain by more than 0.02 rad. Either the body has
/// turned too far for a double's phase, or the run amplifies the rounding of its input, most of all close to the
/// separatrix. Empty otherwise, and for driven motion.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::reference
