// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_known_motion.h"

#include <utility>

#include "core/error.h"
#include "core/expect.h"

namespace poinsot::reference {
namespace {

bool holds(const physics::TimeSpan& span, double t_s) { return span.from_s <= t_s && t_s <= span.to_s; }

}  // namespace

bool KnownMotion::extend(const MotionMaker& maker, const physics::TimeSpan& span) {
  try {
    Part part{span, maker(span)};
    for (const double end_s : {span.from_s, span.to_s}) part.motion->at(end_s);  // throws if too far from 0
    parts_.push_back(std::move(part));
    return true;
  } catch (const core::Error&) {
    return false;  // grading continues without these times
  }
}

const physics::Motion* KnownMotion::motionAt(double t_s) const {
  if (holds(span_, t_s)) return &motion_;
  for (const Part& part : parts_)
    if (holds(part.span, t_s)) return part.motion.get();
  return nullptr;
}

physics::RigidBodyState KnownMotion::at(double t_s) const {
  const physics::Motion* motion = motionAt(t_s);
  POINSOT_EXPECT(motion != nullptr);
  return motion->at(t_s);
}

}  // namespace poinsot::reference
