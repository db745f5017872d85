// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "reference/grade.h"
#include "reference/grade_known_motion.h"
#include "reference/grade_state.h"

namespace poinsot::reference {

/// Rows of a log, each with the motion's state at its time.
struct LogSample {
  std::vector<LoggedState> theirs;
  std::vector<physics::RigidBodyState> ours;
};

/// Returns the largest |omega| of the motion in a sample, rad/s.
double largestOmega(const LogSample& sample);

/// Root mean square errors of a sample; nullopt if the log lacks the columns.
struct Misfit {
  std::optional<double> attitude;  ///< rad
  std::optional<double> omega;     ///< relative to the largest |omega| of the sample
};

Misfit misfitOf(const LogSample& sample);

/// Returns the sum of the misfits' logarithms; all misfits below rounding count alike.
double scoreOf(const Misfit& misfit);
double scoreOf(const LogSample& sample);

/// Part of a log that a reading changes, in order of application; a log has at most one reading of each part.
enum class Aspect { kOrder, kSense, kUnit, kFrame, kTimeUnit, kShift, kAxes, kRate };

/// Way to read a log that differs from what its column names mean.
struct Reading {
  Aspect aspect;
  FitCause cause;
  std::function<LoggedState(LoggedState)> apply;
};

LoggedState readAs(LoggedState state, const std::vector<Reading>& readings);
/// Applies readings to a sample. Returns nullopt if the motion is unknown at a time that results.
std::optional<LogSample> readAs(const LogSample& asWritten, const std::vector<Reading>& readings,
                                const KnownMotion& motion);

/// Convention that logs commonly use instead of poinsot's.
struct Hypothesis {
  Aspect aspect;
  /// Returns the reading of this kind that fits the sample best; nullopt if the log lacks the columns.
  std::function<std::optional<Reading>(const LogSample&)> reading;
};

/// Returns hypotheses without a fit: order and sense of a quaternion, units, frames, omega as the rate of turning.
std::vector<Hypothesis> namedHypotheses(const physics::Motion& motion);

}  // namespace poinsot::reference
