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

/// Direction in which the energy or angular momentum of a log drifts.
enum class Trend { kNone, kLoses, kGains };

/// Summary of the errors of one quantity over all rows of a log.
struct ErrorSummary {
  double largest = 0;      ///< largest error; infinite if a value is not finite
  double largestAt_s = 0;  ///< motion time of the largest error; the first if there are several
  double final = 0;        ///< error at the last row in the order of grading
  double rms = 0;          ///< root mean square over the rows
  Drift drift;
  /// Only for |L| and T: error at the last row with its sign, log minus motion. Relative if the other errors are.
  std::optional<double> signedFinal;
  /// Only for |L| and T: sign of the error over the last quarter of the rows. kNone if the error does not drift.
  Trend trend = Trend::kNone;
};

struct GradedQuantity {
  std::string_view key;    ///< name in the JSON output
  std::string_view label;  ///< name in the table for people
  /// "1" for errors relative to the largest true value, "rad" for angles. If all true values are 0, the unit of
  /// the quantity.
  std::string_view unit;
  std::string from;                    ///< names of the columns from which the quantity is computed
  std::optional<ErrorSummary> errors;  ///< nullopt if the log lacks the columns
};

/// Returns the unit with a space before it, such as " rad". Empty for a relative error.
std::string unitAfter(const GradedQuantity& quantity);

/// Way in which a log deviates from the meaning of its column names.
struct FitCause {
  std::string condition;  ///< text after "fits if", such as "t is 0.5 s later"
  std::string remark;     ///< text on the convention that the log follows, or on how to fix the log
};

/// Set of readings with which a log fits the motion, and the remaining errors.
struct Fit {
  std::vector<FitCause> causes;            ///< one for each reading; all are needed together
  std::vector<GradedQuantity> quantities;  ///< errors with the readings applied; rows at unknown times are omitted
};

/// Comparison of a logged trajectory with the exact motion.
struct Grade {
  std::size_t rows = 0;
  double first_s = 0, last_s = 0;  ///< motion times of the first and last row in the order of grading
  std::vector<GradedQuantity> quantities;
  std::optional<Fit> fit;          ///< nullopt if the log fits as written, or if no known convention makes it fit
  std::vector<std::string> notes;  ///< remarks on other readings, and on tolerated faults of the log

  /// Returns the quantity with a key. @pre the key exists
  const GradedQuantity& quantity(std::string_view key) const;
};

/// Returns the smallest and largest time of a table.
physics::TimeSpan spanOf(const TrajectoryTable& theirs);

/// Compares each row of a log with the motion at the row's time t. In the following, primes mark values of the
/// log:
///   attitude: angle of q^-1 q', 2 atan2(|vector|, |scalar|); q' is normalised and may have either sign
///   omega_B, omega_W, rate_B, rate_W: |omega' - omega|, relative to the largest |omega| of the run
///   direction of L: angle between L' and L
///   |L|, T: difference, relative to the largest value of the run
/// If the log lacks L' or T', they are computed: L' = q' (I omega_B'), T' = omega_B' I omega_B' / 2. If the log
/// lacks omega_B', it is computed from omega_W' and q'. Rows are graded in the order of time, or backwards from 0
/// if no time is positive. If the log does not fit, other common conventions are tried (grade_convention.h).
/// @param maker  makes the same motion over another span, to detect a clock with another zero; empty: not detected
/// @throws core::Error(kLimit) if the motion is unknown at a time of the log
Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs, const MotionMaker& maker = {});

/// Grades a log with its first row moved to motion time 0. Use this function if the log's clock is so far from 0
/// that the motion is unknown at its times. @throws core::Error of the maker.
Fit gradeFromZero(const MotionMaker& maker, const TrajectoryTable& theirs);

/// Returns a text on the readings and the largest errors that remain, such as "fits if t is 0.5 s later (...):
/// attitude 3.4e-13 rad, omega in the body 2.1e-12".
std::string fitNote(const Fit& fit);

/// Returns a text on a result of gradeFromZero(). This is fitNote() if the log fits, otherwise "graded from its
/// first row: attitude 3.0e+00 rad, omega in the body 1.2e+00".
std::string firstRowNote(const Fit& fit);

}  // namespace poinsot::reference
