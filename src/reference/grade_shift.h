// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Logs whose clock has another zero: t + shift is the motion's time. The first row is looked for in the motion
/// around its own t and around 0, then all rows are fitted (Gauss and Newton's method).
/// @param motion  made known over the spans that are searched. @param maker  makes it so; without it, no shift.
/// @param span  of the log's times. Both outlive the hypothesis.
Hypothesis shiftHypothesis(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span);

/// t + shift_s is the motion's time. @param first_s  t of the first row.
Reading shiftReading(double shift_s, double first_s);

}  // namespace poinsot::reference
