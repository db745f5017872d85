// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "reference/grade.h"
#include "reference/grade_known_motion.h"
#include "reference/grade_state.h"

namespace poinsot::reference {

/// Rows of a log, each with the state of the motion at the same time.
struct LogSample {
  std::vector<LoggedState> theirs;
  std::vector<physics::RigidBodyState> ours;
};

/// Returns the largest |omega| of the motion in the sample, rad/s.
double largestOmega(const LogSample& sample);

/// Root mean square errors of a sample. nullopt if the log lacks the columns.
struct Misfit {
  std::optional<double> attitude;  ///< rad
  std::optional<double> omega;     ///< relative to the largest |omega| of the sample
};

Misfit misfitOf(const LogSample& sample);

/// Returns a score, the sum of the misfits' logarithms: smaller is better. Differences below rounding do not
/// count.
double scoreOf(const Misfit& misfit);
double scoreOf(const LogSample& sample);

/// Aspect of a log that a reading changes. Readings are applied in this order, at most one for each aspect.
enum class Aspect { kOrder, kSense, kUnit, kFrame, kTimeUnit, kShift, kAxes, kRate };

/// Alternative reading of a log: a function that converts a row to poinsot's conventions, and the cause in words.
struct Reading {
  Aspect aspect;
  FitCause cause;
  std::function<LoggedState(LoggedState)> apply;
};

LoggedState readAs(LoggedState state, const std::vector<Reading>& readings);
/// Applies readings to a sample. Returns nullopt if the motion is unknown at one of the new times.
std::optional<LogSample> readAs(const LogSample& asWritten, const std::vector<Reading>& readings,
                                const KnownMotion& motion);

/// Convention that many programs use instead of poinsot's, and that a log may follow.
struct Hypothesis {
  Aspect aspect;
  /// Returns the best reading with this convention, or nullopt if the log lacks the columns.
  std::function<std::optional<Reading>(const LogSample&)> reading;
};

/// Returns the hypotheses without a fitted parameter: other order or sense of the quaternion, other units or
/// frames, and the rate of rotation in the columns of omega.
std::vector<Hypothesis> namedHypotheses(const physics::Motion& motion);

}  // namespace poinsot::reference
