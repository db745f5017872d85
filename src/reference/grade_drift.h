// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "core/abi.h"

namespace poinsot::reference {

enum class DriftKind {
  kTooFewRows,  ///< nothing to say
  kRounding,    ///< never above kRoundingError
  kLevel,       ///< an error, but one that does not grow
  kDrift,       ///< from some time on it grows, or has grown for good
};

enum class Growth { kUnclear, kPower, kExponential };

/// When an error starts to grow, and how.
struct Drift {
  DriftKind kind = DriftKind::kTooFewRows;
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< kDrift: last time at which it was as before
  Growth growth = Growth::kUnclear;
  double order = std::numeric_limits<double>::quiet_NaN();  ///< kPower: of (t - from); about 0: a step
  double rate = std::numeric_limits<double>::quiet_NaN();   ///< kExponential: 1/s
};

/// Errors below it, in rad or relative, are rounding and no drift: some hundred times what a copy of the motion
/// has.
inline constexpr double kRoundingError = 1e-13;

/// Where the error is no longer small: angles and relative errors level off above it, so growth is judged below.
inline constexpr double kLostError = 0.5;

/// Finds the drift of errors >= 0 (rad or relative; may be infinite) at times t in order, away from the first.
///
/// The rows, up to the first error beyond kLostError, are taken in up to 125 groups, each by its largest error e.
/// Of all models "constant before group s, a (t - t_s)^p from it on" the one that fits ln e best (least squares)
/// says where and how the error grows; so no threshold has to be chosen, and an engine that prints six digits is
/// judged like one that prints sixteen. Growth from the first row on is believed unless another start halves its
/// residual. It is a drift if the model explains at least half of the scatter about one constant, and leads to
/// four times the level before. The time given is that of the last row up to group s within twice the largest
/// error of the groups before s - 1, and the order p is fitted again from there. exp(rate t) is reported where it
/// leaves less than half the residual of the power; neither where more than a tenth of the scatter stays
/// unexplained.
/// @pre as many times as errors
Drift findDrift(std::span<const double> t_s, std::span<const double> errors);

}  // namespace poinsot::reference
