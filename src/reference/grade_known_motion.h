// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "physics/driven_motion.h"

namespace poinsot::reference {

/// Makes the motion that a log is graded against, known over another span. @throws core::Error
using MotionMaker = std::function<std::unique_ptr<const physics::Motion>(const physics::TimeSpan&)>;

/// One motion, known over several spans of time: a driven motion is integrated over the span it is wanted for.
class KnownMotion {
 public:
  /// @param motion  outlives this. @param span  where it is known, as well as between that and 0.
  KnownMotion(const physics::Motion& motion, const physics::TimeSpan& span)
      : motion_(motion), span_{std::min(0., span.from_s), std::max(0., span.to_s)} {}

  /// Makes the motion known over another span, too. Returns false if it cannot be made: too many steps, losses
  /// that have no past, or times beyond the range of numbers.
  bool extend(const MotionMaker& maker, const physics::TimeSpan& span);

  bool knows(double t_s) const { return motionAt(t_s) != nullptr; }
  /// @pre knows(t_s)
  physics::RigidBodyState at(double t_s) const;
  const physics::Motion& motion() const { return motion_; }

 private:
  struct Part {
    physics::TimeSpan span;
    std::unique_ptr<const physics::Motion> motion;
  };

  const physics::Motion* motionAt(double t_s) const;

  const physics::Motion& motion_;
  physics::TimeSpan span_;
  std::vector<Part> parts_;
};

}  // namespace poinsot::reference
