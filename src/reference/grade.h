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

/// Direction in which an engine's energy or angular momentum drifts.
enum class Trend { kNone, kLoses, kGains };

/// Summary of one quantity's errors over all rows of a log.
struct ErrorSummary {
  double largest = 0;      ///< infinite if a value is not finite
  double largestAt_s = 0;  ///< first motion time of the largest error
  double final = 0;        ///< error at the row farthest from the start
  double rms = 0;          ///< root mean square over the rows
  Drift drift;
  /// For |L| and T: signed final error, the log's value minus the motion's; relative like the other errors.
  std::optional<double> signedFinal;
  /// For |L| and T: the sign of the error over the last quarter of the rows, if the error drifts; otherwise kNone.
  Trend trend = Trend::kNone;
};

struct GradedQuantity {
  std::string_view key;    ///< name in JSON
  std::string_view label;  ///< name in the table
  std::string_view unit;   ///< "1" if relative to the largest true value of the run; "rad" for angles; the
                           ///< quantity's own unit if all its true values are 0
  std::string from;        ///< columns of the log from which the quantity is computed
  std::optional<ErrorSummary> errors;  ///< nullopt if the log lacks the columns
};

/// Returns the unit after a blank, such as " rad"; empty for a relative error.
std::string unitAfter(const GradedQuantity& quantity);

/// One way in which a log deviates from what its columns' names mean.
struct FitCause {
  std::string condition;  ///< completes "fits if ...", for example "t is 0.5 s later"
  std::string remark;     ///< whose convention the log follows, and what to do
};

/// Alternative reading of a log in which it fits the motion.
struct Fit {
  std::vector<FitCause> causes;            ///< all of them apply together
  std::vector<GradedQuantity> quantities;  ///< in this reading, without rows whose motion is unknown
};

/// Comparison of a logged trajectory with the exact motion.
struct Grade {
  std::size_t rows = 0;
  double first_s = 0, last_s = 0;  ///< motion times of the first and last judged row
  std::vector<GradedQuantity> quantities;
  std::optional<Fit> fit;          ///< nullopt if the log fits as written, or under no usual convention
  std::vector<std::string> notes;  ///< remarks on other possible readings, and on faults that were tolerated

  /// Returns the quantity with a key. @pre the key exists
  const GradedQuantity& quantity(std::string_view key) const;
};

/// Returns the least and largest time of a table.
physics::TimeSpan spanOf(const TrajectoryTable& theirs);

/// Compares each row of a log with the motion at the row's own t; primes mark the log's values:
///   attitude: angle of q^-1 q', 2 atan2(|vector|, |scalar|); q' of either sign, and normalised
///   omega_B, omega_W, rate_B, rate_W: |omega' - omega|, relative to the largest |omega| of the run
///   direction of L: angle between L' and L;   |L|, T: difference, relative to the largest of the run
/// L' and T' are columns of the log, or computed from others: L' = q' (I omega_B'), T' = omega_B' I omega_B' / 2,
/// and omega_B' from omega_W' by q'. Rows are judged in the order of time, backwards from 0 if no time is
/// positive. If a log does not fit, usual other conventions are tried (grade_convention.h).
/// @param maker  makes the same motion over another span, to find a clock with another zero; if empty, none is
/// sought
/// @throws core::Error(kLimit) if the motion is unknown at a time of the log
Grade grade(const physics::Motion& motion, const TrajectoryTable& theirs, const MotionMaker& maker = {});

/// Grades a log as if its first row were at motion time 0. Serves logs whose clock is so late that the motion is
/// not known at its times. @throws core::Error as the maker does.
Fit gradeFromZero(const MotionMaker& maker, const TrajectoryTable& theirs);

/// Returns a text with the largest errors that are left, such as "fits if t is 0.5 s later (...): attitude 3.4e-13
/// rad, omega in the body 2.1e-12".
std::string fitNote(const Fit& fit);

/// Describes a result of gradeFromZero(): fitNote() if it fits, otherwise "graded from its first row: attitude
/// 3.0e+00 rad, omega in the body 1.2e+00".
std::string firstRowNote(const Fit& fit);

}  // namespace poinsot::reference
