// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "reference/grade.h"
#include "reference/grade_known_motion.h"
#include "reference/grade_state.h"

namespace poinsot::reference {

/// Some rows of a log, each beside the motion's state at its time.
struct LogSample {
  std::vector<LoggedState> theirs;
  std::vector<physics::RigidBodyState> ours;
};

/// Largest |omega| of the motion in a sample, rad/s.
double largestOmega(const LogSample& sample);

/// Root mean squares over a sample; none: the columns are absent.
struct Misfit {
  std::optional<double> attitude;  ///< rad
  std::optional<double> omega;     ///< relative to the largest |omega| of the sample
};

Misfit misfitOf(const LogSample& sample);

/// Grows with the misfits' orders of magnitude: a sum of their logarithms, all below rounding being alike.
double scoreOf(const Misfit& misfit);
double scoreOf(const LogSample& sample);

/// The part of a log that a reading changes, in order of application; a log has one reading of each.
enum class Aspect { kOrder, kSense, kUnit, kFrame, kTimeUnit, kShift, kAxes, kRate };

/// A way to read a log other than the one in which its columns are named.
struct Reading {
  Aspect aspect;
  FitCause cause;
  std::function<LoggedState(LoggedState)> apply;
};

/// Returns the row with all readings applied, in their order.
LoggedState readAs(LoggedState state, const std::vector<Reading>& readings);
/// Reads a sample likewise; returns nothing if the motion is not known at the times that it then has.
std::optional<LogSample> readAs(const LogSample& asWritten, const std::vector<Reading>& readings,
                                const KnownMotion& motion);

/// A usual way to write logs.
struct Hypothesis {
  Aspect aspect;
  /// The reading of this kind that fits the sample best; nothing where the log has no such columns.
  std::function<std::optional<Reading>(const LogSample&)> reading;
};

/// Hypotheses without a free number: order and sense of a quaternion, units, frames, omega as the rate of turning.
std::vector<Hypothesis> namedHypotheses(const physics::Motion& motion);

}  // namespace poinsot::reference
