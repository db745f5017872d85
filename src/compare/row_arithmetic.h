// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "compare/kernel.h"

namespace poinsot::compare {

/// Arithmetic over the columns of a row. All pointers point to column 0 of a row. Results have the same bits with
/// and without a vector unit.

/// Adds `factor` times x to `sum`.
void addScaled(const double* x, double factor, ColumnSpan where, double* sum);

/// Replaces x by √(x² + y²) / divisor.
void toLengths(double* x, const double* y, double divisor, ColumnSpan where);

/// Replaces linear RGB by opponent colours Y Cx Cz, see flip_color.h.
void toOpponent(const std::array<double*, 3>& color, ColumnSpan where);

/// Replaces opponent colours Y Cx Cz by Hunt-adjusted CIELab, see flip_color.h.
void toHuntLab(const std::array<double*, 3>& color, ColumnSpan where);

/// Row of a picture as the eye perceives it: the colour in Hunt-adjusted CIELab, and the strengths of edges and
/// points.
struct PerceivedRow {
  std::array<const double*, 3> color;
  const double *edge, *point;
};
/// Computes FLIP's errors of two rows.
void flipErrors(const PerceivedRow& a, const PerceivedRow& b, ColumnSpan where, double* errors);

/// Means of a, b, a² + b² and 2ab in the window around each column.
using WindowMeans = std::array<const double*, 4>;
/// Computes the SSIM of each window.
void similarities(const WindowMeans& means, ColumnSpan where, double* out);

}  // namespace poinsot::compare
