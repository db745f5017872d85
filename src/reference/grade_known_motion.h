// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "physics/driven_motion.h"

namespace poinsot::reference {

/// Function that makes the motion that a log is graded against, known over a given span. May throw core::Error.
using MotionMaker = std::function<std::unique_ptr<const physics::Motion>(const physics::TimeSpan&)>;

/// One motion, known over several spans of time. A driven motion is integrated over each span that is needed.
class KnownMotion {
 public:
  /// @param motion  must outlive this object
  /// @param span  span over which `motion` is known, extended to include 0
  KnownMotion(const physics::Motion& motion, const physics::TimeSpan& span)
      : motion_(motion), span_{std::min(0., span.from_s), std::max(0., span.to_s)} {}

  /// Makes the motion known over another span, too. Returns false if this fails because of too many steps, of
  /// losses that cannot be followed backwards, or of times out of range.
  bool extend(const MotionMaker& maker, const physics::TimeSpan& span);

  bool knows(double t_s) const { return motionAt(t_s) != nullptr; }
  /// Returns the state at a motion time. @pre knows(t_s)
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
