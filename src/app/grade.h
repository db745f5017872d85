// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/grade_drift.h"
#include "app/grade_table.h"
#include "physics/driven_motion.h"

namespace poinsot::app {

/// Errors of one quantity over all rows.
struct ErrorSummary {
  double largest = 0;      ///< infinite where a value is not finite
  double largestAt_s = 0;  ///< first time it is reached
  double final = 0;        ///< at the row farthest from the start
  double rms = 0;          ///< over the rows
  Drift drift;
};

struct GradedQuantity {
  std::string_view key;    ///< in JSON
  std::string_view label;  ///< in the table
  std::string_view unit;   ///< "rad", or "1" for an error relative to the largest true value of the run
  std::string from;        ///< their columns that it was worked out from
  std::optional<ErrorSummary> errors;  ///< none: the columns it takes are absent
};

/// How far a trajectory is off the motion.
struct Grade {
  std::size_t rows = 0;
  double first_s = 0, last_s = 0;  ///< motion times, in the order judged
  std::vector<GradedQuantity> quantities;
  std::vector<std::string> notes;  ///< what was forgiven, and how else theirs may be meant

  /// @pre the key exists
  const GradedQuantity& quantity(std::string_view key) const;
};

/// Least and largest time of a table.
physics::TimeSpan spanOf(const TrajectoryTable& theirs);

/// Compares row by row with the motion at the row's own t:
///   attitude: angle of q^-1 q', 2 atan2(|vector|, |scalar|); q' of either sign, and normalised
///   omega_B, omega_W: |omega' - omega|, relative to the largest |omega| of the run
///   direction of L: angle between L' and L;   |L|, T: difference, relative to the largest of the run
/// L' and T' are their columns; else worked out from what they have: L' = q' (I omega_B'), T' = omega_B' I
/// omega_B' / 2, omega_B' from omega_W' by q'. Rows are judged in the order of time, backwards from 0 where no
/// time is positive.
/// @pre the motion is known over spanOf(theirs)
Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs);

}  // namespace poinsot::app
