// SPDX-License-Identifier: Apache-2.0
// The compiler vectorises the loops of this file, which has its own options for this in CMakeLists.txt.
#include "compare/row_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flip_color.h"
#include "compare/vectorised.h"

namespace poinsot::compare {

POINSOT_VECTORISED
void addScaled(const double* __restrict x, double factor, ColumnSpan where, double* __restrict sum) {
  for (int i = where.begin; i < where.end; ++i) sum[i] += factor * x[i];
}

POINSOT_VECTORISED
void toLengths(double* __restrict x, const double* __restrict y, double divisor, ColumnSpan where) {
  for (int i = where.begin; i < where.end; ++i) x[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]) / divisor;
}

POINSOT_VECTORISED
void toOpponent(const std::array<double*, 3>& color, ColumnSpan where) {
  double* __restrict c0 = color[0], * __restrict c1 = color[1], * __restrict c2 = color[2];
  for (int i = where.begin; i < where.end; ++i) {
    const Triple opponent = opponentColor({c0[i], c1[i], c2[i]});
    c0[i] = opponent[0];
    c1[i] = opponent[1];
    c2[i] = opponent[2];
  }
}

POINSOT_VECTORISED
void toHuntLab(const std::array<double*, 3>& color, ColumnSpan where) {
  double* __restrict c0 = color[0], * __restrict c1 = color[1], * __restrict c2 = color[2];
  for (int i = where.begin; i < where.end; ++i) {
    const Triple lab = huntLab(rgbOfOpponent({c0[i], c1[i], c2[i]}));
    c0[i] = lab[0];
    c1[i] = lab[1];
    c2[i] = lab[2];
  }
}

POINSOT_VECTORISED
void flipErrors(const PerceivedRow& a, const PerceivedRow& b, ColumnSpan where, double* __restrict errors) {
  const auto [a0, a1, a2] = a.color;
  const auto [b0, b1, b2] = b.color;
  const double *edgeA = a.edge, *edgeB = b.edge, *pointA = a.point, *pointB = b.point;
  const double largest = largestColorDistance();
  for (int i = where.begin; i < where.end; ++i) {
    const double color = colorError({a0[i], a1[i], a2[i]}, {b0[i], b1[i], b2[i]}, largest);
    const double feature = std::max(std::abs(edgeA[i] - edgeB[i]), std::abs(pointA[i] - pointB[i]));
    errors[i] = powerFromZero(color, 1 - std::sqrt(feature / std::numbers::sqrt2));
  }
}

POINSOT_VECTORISED
void similarities(const WindowMeans& means, ColumnSpan where, double* __restrict out) {
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
  const auto [as, bs, squares, products] = means;
  for (int i = where.begin; i < where.end; ++i) {
    const double a = as[i], b = bs[i];
    const double product = 2 * a * b, square = a * a + b * b;
    const double variances = squares[i] - square, covariances = products[i] - product;
    out[i] = (product + kC1) * (covariances + kC2) / ((square + kC1) * (variances + kC2));
  }
}

}  // namespace poinsot::compare
