// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/driven_motion.h"
#include "reference/grade_drift.h"
#include "reference/grade_known_motion.h"
#include "reference/grade_table.h"

namespace poinsot::reference {

/// Which way an engine's energy or angular momentum is off.
enum class Trend { kNone, kLoses, kGains };

/// Errors of one quantity over all rows.
struct ErrorSummary {
  double largest = 0;      ///< infinite where a value is not finite
  double largestAt_s = 0;  ///< first time it is reached
  double final = 0;        ///< at the row farthest from the start
  double rms = 0;          ///< over the rows
  Drift drift;
  /// |L| and T: theirs minus the motion's at the last row, relative as the other errors are. Negative: too little.
  std::optional<double> signedFinal;
  /// |L| and T: the sign that their error has over the last quarter of the rows, where it drifts; else none.
  Trend trend = Trend::kNone;
};

struct GradedQuantity {
  std::string_view key;    ///< in JSON
  std::string_view label;  ///< in the table
  std::string_view unit;   ///< "1" for an error relative to the largest true value of the run; "rad" for an
                           ///< angle; that of the quantity if its true values are all 0
  std::string from;        ///< their columns that it was worked out from
  std::optional<ErrorSummary> errors;  ///< none: the columns it takes are absent
};

/// Returns " rad" or another unit after a blank; "" for a relative error.
std::string unitAfter(const GradedQuantity& quantity);

/// One thing that a log means otherwise than its columns' names say.
struct FitCause {
  std::string condition;  ///< completes "fits if ...": "t is 0.5 s later"
  std::string remark;     ///< whose convention that is, and what to do
};

/// Another way to read a log, in which it fits.
struct Fit {
  std::vector<FitCause> causes;            ///< that hold together
  std::vector<GradedQuantity> quantities;  ///< graded as read so, except rows at times without a motion
};

/// How far a trajectory is off the motion.
struct Grade {
  std::size_t rows = 0;
  double first_s = 0, last_s = 0;  ///< motion times, in the order judged
  std::vector<GradedQuantity> quantities;
  std::optional<Fit> fit;          ///< none: it fits as it is written, or in no usual way
  std::vector<std::string> notes;  ///< how else theirs may be meant, and what was forgiven

  /// @pre the key exists
  const GradedQuantity& quantity(std::string_view key) const;
};

/// Least and largest time of a table.
physics::TimeSpan spanOf(const TrajectoryTable& theirs);

/// Compares row by row with the motion at the row's own t:
///   attitude: angle of q^-1 q', 2 atan2(|vector|, |scalar|); q' of either sign, and normalised
///   omega_B, omega_W, rate_B, rate_W: |omega' - omega|, relative to the largest |omega| of the run
///   direction of L: angle between L' and L;   |L|, T: difference, relative to the largest of the run
/// L' and T' are their columns; else worked out from what they have: L' = q' (I omega_B'), T' = omega_B' I
/// omega_B' / 2, omega_B' from omega_W' by q'. Rows are judged in the order of time, backwards from 0 where no
/// time is positive. Where they are off, a usual other way to read them is looked for (grade_convention.h).
/// @param maker  makes the same motion over another span, to look for a clock with another zero; without it, none
/// is looked for.
/// @throws core::Error(kLimit) where the motion is not known at a time of theirs.
Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs, const MotionMaker& maker = {});

/// Grades a log as if its first row were at motion time 0: where a clock's time is too late for the motion to be
/// known there. @throws core::Error as the maker does.
Fit gradeFromZero(const MotionMaker& maker, const TrajectoryTable& theirs);

/// "fits if t is 0.5 s later (...): attitude 3.4e-13 rad, omega in the body 2.1e-12": the largest errors that are
/// left.
std::string fitNote(const Fit& fit);

/// Describes a grade from the first row, which is compared with no other: as fitNote() if it fits, else "graded
/// from its first row: attitude 3.0e+00 rad, omega in the body 1.2e+00".
std::string firstRowNote(const Fit& fit);

}  // namespace poinsot::reference
