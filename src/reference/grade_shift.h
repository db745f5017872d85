// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns the hypothesis that the log's clock has another zero, so that t + shift is the motion time. Searches
/// the motion for a state like the first row, around its time t and around 0. Then fits the shift to all rows
/// (Gauss-Newton method).
/// @param motion, maker  the maker adds the searched spans to the motion; without a maker, no shift is found. Both
/// must outlive the hypothesis.
/// @param span  first and last time of the log
Hypothesis shiftHypothesis(KnownMotion& motion, const MotionMaker& maker, const physics::TimeSpan& span);

/// Returns the reading with motion times t + shift_s. @param first_s  time t of the first row
Reading shiftReading(double shift_s, double first_s);

}  // namespace poinsot::reference
