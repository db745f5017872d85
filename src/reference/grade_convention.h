// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns readings of a log that together make it fit the motion. Returns none if the log fits as written, or if
/// no known convention makes it fit. With the result, a caller can distinguish a wrong motion from a different
/// convention.
///
/// Up to 64 rows of the log are read in each known way (grade_reading.h, grade_shift.h, grade_turn.h). A misfit is
/// the rms error of the attitude (rad) or of omega (relative); above 1e-3 it is wrong. A reading is accepted if it
/// reduces a wrong misfit to a twentieth or less. The other misfit must at most double, or stay below 5e-5. Of the
/// accepted readings, the best is chosen, and the simplest of equally good ones. If no reading reduces every wrong
/// misfit, pairs of readings are tried. The search is repeated for the misfits that are still wrong.
///
/// @param motion  motion that is known at the log's times; on return, also at the times that the readings need
/// @param maker  makes the motion over other spans; if empty, no reading shifts the time
std::vector<Reading> fittingReadings(KnownMotion& motion, const MotionMaker& maker, const TrajectoryTable& theirs);

}  // namespace poinsot::reference
