// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "physics/driven_motion.h"

namespace poinsot::reference {

/// Function that makes the motion for a given span of time, to compare a log with it. May throw core::Error.
using MotionMaker = std::function<std::unique_ptr<const physics::Motion>(const physics::TimeSpan&)>;

/// Motion that is known over several spans of time. A driven motion is integrated separately for each span.
class KnownMotion {
 public:
  /// @param motion  must outlive this object
  /// @param span  times at which `motion` is known; 0 is always included
  KnownMotion(const physics::Motion& motion, const physics::TimeSpan& span)
      : motion_(motion), span_{std::min(0., span.from_s), std::max(0., span.to_s)} {}

  /// Adds another span of time to the motion. Returns false on failure: too many integration steps, dissipation
  /// that cannot be followed backwards, or times out of range.
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
