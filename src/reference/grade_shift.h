// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns the hypothesis that the log's clock has another zero: t + shift is the motion's time. Looks for the
/// first row in the motion around its own t and around 0, then fits the shift to all rows (Gauss-Newton method).
/// @param motion, maker  the maker extends the motion over the searched spans; without a maker, no shift is found.
/// Both must outlive the hypothesis.
/// @param span  times of the log
Hypothesis shiftHypothesis(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span);

/// Returns the reading with motion times t + shift_s. @param first_s  t of the first row.
Reading shiftReading(double shift_s, double first_s);

}  // namespace poinsot::reference
