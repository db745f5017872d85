// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns readings of a log that together make it fit the motion. Returns none if the log fits as written, or
/// under no usual convention.
///
/// Distinguishes a wrong motion from one that is written in another convention. Up to 64 rows, spread over the
/// log, are read in each usual way (grade_reading.h, grade_shift.h, grade_turn.h). A reading counts if it reduces
/// a misfit of the attitude or of omega above 1e-3 to a twentieth, and at most doubles the other, or keeps it
/// below 5e-5. The best reading is chosen, and of equals the simplest. If no single reading reduces every misfit,
/// pairs are tried. The search then goes on with what is still wrong.
///
/// @param motion  known over the log's times; on return also over the times under the readings
/// @param maker  makes the motion over other spans; if empty, no reading shifts the time
std::vector<Reading> fittingReadings(KnownMotion& motion, const MotionMaker& maker, const TrajectoryTable& theirs);

}  // namespace poinsot::reference
