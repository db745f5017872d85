// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Readings of a log that together make it fit the motion; empty where it fits as it is written, or in no usual
/// way.
///
/// Tells a motion that is wrong from one that is written down otherwise: some rows, spread over the log, are read
/// in each usual way (grade_reading.h, grade_shift.h, grade_turn.h). One counts if a misfit of the attitude or of
/// omega beyond a thousandth falls to a twentieth, and none grows. Of those the one that fits best is taken, of
/// equals the plainest; two together are tried where none alone makes all better that is wrong. What is still
/// wrong is looked into again.
///
/// @param motion  known over the log's times; afterwards also at the times that the readings give it.
/// @param maker  makes it known elsewhere; without it, no reading has another zero of time.
std::vector<Reading> fittingReadings(KnownMotion& motion, const MotionMaker& maker, const TrajectoryTable& theirs);

}  // namespace poinsot::reference
