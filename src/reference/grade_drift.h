// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

#include "core/abi.h"

namespace poinsot::reference {

enum class DriftKind {
  kTooFewRows,
  kRounding,  ///< the error is never larger than kRoundingError
  kLevel,     ///< the error does not grow
  kDrift,     ///< the error grows from some time on, or exceeds kLostError
};

enum class Growth { kUnclear, kPower, kExponential };

/// Growth of an error: the time at which it starts, and the law.
struct Drift {
  DriftKind kind = DriftKind::kTooFewRows;
  double from_s = std::numeric_limits<double>::quiet_NaN();  ///< kDrift: last time before the error grows
  Growth growth = Growth::kUnclear;
  double order = std::numeric_limits<double>::quiet_NaN();  ///< kPower: exponent of (t - from); about 0 for a step
  double rate = std::numeric_limits<double>::quiet_NaN();   ///< kExponential: growth rate in 1/s
};

/// Largest error, in rad or relative, that counts as rounding and not as drift. It is some hundred times the
/// rounding error of a copied motion.
inline constexpr double kRoundingError = 1e-13;

/// Error above which the growth is not judged, because angles and relative errors level off.
inline constexpr double kLostError = 0.5;

/// Finds out whether errors drift: when they start to grow, and by which law.
///
/// Judges the rows up to the first error above kLostError. The rows form up to 125 groups, and each group is
/// represented by its largest error e. The model is an error that is constant before a group s, and a (t - t_s)^p
/// from then on. The group s is the one with the best least-squares fit of ln e. There is no threshold, so engines
/// with six and with sixteen printed digits are judged alike. The growth starts at the first row, unless another
/// start halves the residual.
///
/// The error drifts if the model explains at least half of the scatter about a constant, and if the last error is
/// four times the level before. The drift starts at the last row, up to group s, whose error is at most twice the
/// largest error of the groups before s - 1. The order p is then fitted again from that row. If an exponential
/// exp(rate t) has less than half the residual of the power, the growth is exponential. If more than a tenth of
/// the scatter stays unexplained, the law is unclear.
/// @param t_s  times in order, away from the first time
/// @param errors  >= 0, rad or relative; may be infinite
/// @pre as many times as errors
Drift findDrift(std::span<const double> t_s, std::span<const double> errors);

}  // namespace poinsot::reference
