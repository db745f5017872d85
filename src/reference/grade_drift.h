// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "core/abi.h"

namespace poinsot::reference {

enum class DriftKind {
  kTooFewRows,
  kRounding,  ///< the error never exceeds kRoundingError
  kLevel,     ///< an error that does not grow
  kDrift,     ///< the error grows from some time on, or has grown for good
};

enum class Growth { kUnclear, kPower, kExponential };

/// Growth of an error: when it starts, and how it grows.
struct Drift {
  DriftKind kind = DriftKind::kTooFewRows;
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< kDrift: last time before the error grows
  Growth growth = Growth::kUnclear;
  double order = std::numeric_limits<double>::quiet_NaN();  ///< kPower: exponent of (t - from); about 0 for a step
  double rate = std::numeric_limits<double>::quiet_NaN();   ///< kExponential: 1/s
};

/// Largest error, in rad or relative, that counts as rounding instead of drift: some hundred times the error of a
/// copy of the motion.
inline constexpr double kRoundingError = 1e-13;

/// Error that is no longer small. Growth is judged below it, because angles and relative errors level off above.
inline constexpr double kLostError = 0.5;

/// Finds the drift of errors at times in order, away from the first time.
///
/// The rows, up to the first error beyond kLostError, form up to 125 groups, each represented by its largest error
/// e. The model is "constant before group s, a (t - t_s)^p from it on", with the s that fits ln e best (least
/// squares). So no threshold has to be chosen, and an engine that prints six digits is judged like one that prints
/// sixteen. Growth from the first row on is assumed unless another start halves its residual. The model is a drift
/// if it explains at least half of the scatter about one constant, and leads to four times the level before. The
/// drift starts at the last row, up to group s, within twice the largest error of the groups before s - 1; the
/// order p is fitted again from there. An exponential exp(rate t) is reported if it leaves less than half the
/// residual of the power, and neither if more than a tenth of the scatter stays unexplained.
/// @param errors  >= 0, rad or relative; may be infinite
/// @pre as many times as errors
Drift findDrift(std::span<const double> t_s, std::span<const double> errors);

}  // namespace poinsot::reference
