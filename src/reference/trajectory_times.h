// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/rational.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// The motion times of a trajectory's rows, in their order, s. However many there are, a rate takes no memory.
class TrajectoryTimes {
 public:
  /// As listed: any order, repeated or not. @throws core::Error(kUsage) for one that is not finite, or none.
  explicit TrajectoryTimes(std::vector<double> listed_s);

  /// start + k/rate for k = 0, 1, ... as far as `span_s` reaches, both ends included where they are hit; backwards
  /// where the span is negative. k/rate is rounded once, nothing accumulates. A last time beyond the end by no
  /// more than the rounding of the span belongs to it.
  /// @throws core::Error(kLimit) if the times are too many to be told apart.
  TrajectoryTimes(const core::Rational& rate_hz, double start_s, double span_s);

  std::int64_t count() const { return count_; }
  double operator[](std::int64_t k) const;

  double earliest_s() const { return earliest_s_; }
  double latest_s() const { return latest_s_; }

 private:
  std::vector<double> listed_s_;  // empty: a rate
  core::Rational rate_hz_;
  double start_s_ = 0;
  double direction_ = 1;
  std::int64_t count_ = 0;
  double earliest_s_ = 0, latest_s_ = 0;
};

/// A sentence if the attitude at the farthest of these motion times is uncertain by more than 0.02 rad: the body
/// has turned too far for a double's phase, or the run amplifies the rounding of its input, most of all close to
/// the separatrix. Empty otherwise, and for driven motion.
std::string accuracyNote(const scene::Scene& scene, const TrajectoryTimes& times);

}  // namespace poinsot::reference
