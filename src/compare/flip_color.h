// SPDX-License-Identifier: Apache-2.0
// Colours in FLIP. All constants are from sections 3 and 4.1 of the paper cited in compare/flip.h. The functions
// have no branches and no calls, so that compilers vectorise the loops that use them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/smooth_functions.h"

namespace poinsot::compare {

/// Colour with three components, in any colour space.
using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

[[gnu::always_inline]] constexpr Triple product(const Matrix& m, const Triple& v) {
  const auto row = [&v](const Triple& r) { return r[0] * v[0] + r[1] * v[1] + r[2] * v[2]; };
  return {row(m[0]), row(m[1]), row(m[2])};
}

constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix inv{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) inv[c][r] = minor(r, c) / determinant;
  return inv;
}

/// Matrix from linear sRGB to XYZ. The entries are fractions, so that the sum of the columns is exactly the white
/// point.
inline constexpr Matrix kXyzFromRgb = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                        {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                        {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

/// Matrix from linear sRGB to XYZ, scaled so that white is (1, 1, 1).
inline constexpr Matrix kRelativeXyzFromRgb = [] {
  constexpr Triple kWhite = product(kXyzFromRgb, {1, 1, 1});
  Matrix m = kXyzFromRgb;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& entry : m[i]) entry /= kWhite[i];
  return m;
}();

inline constexpr Matrix kRgbFromRelativeXyz = inverse(kRelativeXyzFromRgb);

/// Converts an sRGB value in [0, 1] to linear light (IEC 61966-2-1).
inline double linearLight(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Converts linear RGB to the linear opponent space Y Cx Cz. Y is the lightness, from -16 to 100. Cx is red
/// against green, Cz is yellow against blue.
[[gnu::always_inline]] inline Triple opponentColor(const Triple& rgb) {
  const auto [x, y, z] = product(kRelativeXyzFromRgb, rgb);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Converts an opponent colour to linear RGB, with each channel clipped to [0, 1].
[[gnu::always_inline]] inline Triple rgbOfOpponent(const Triple& yCxCz) {
  const double y = (yCxCz[0] + 16) / 116, x = y + yCxCz[1] / 500, z = y - yCxCz[2] / 200;
  const Triple rgb = product(kRgbFromRelativeXyz, {x, y, z});
  const auto clipped = [](double v) { return std::min(std::max(v, 0.0), 1.0); };
  return {clipped(rgb[0]), clipped(rgb[1]), clipped(rgb[2])};
}

/// Converts linear RGB to CIELab (D65), adjusted for the Hunt effect: a and b become smaller for dark colours.
[[gnu::always_inline]] inline Triple huntLab(const Triple& rgb) {
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29, kKnee = kDelta * kDelta * kDelta;
    const double root = cubeRoot(std::max(t, kKnee)), line = t / (3 * kDelta * kDelta) + 4.0 / 29;
    return t > kKnee ? root : line;
  };
  const Triple xyz = product(kRelativeXyzFromRgb, rgb);
  const double fx = f(xyz[0]), fy = f(xyz[1]), fz = f(xyz[2]);
  const double lightness = 116 * fy - 16;
  return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

/// Returns the HyAB distance of two Lab colours: |ΔL| + √(Δa² + Δb²).
[[gnu::always_inline]] inline double hyabDistance(const Triple& a, const Triple& b) {
  const double da = a[1] - b[1], db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

/// Returns x^y for x from 0 and y from 0 to 1; 0 if x is 0.
[[gnu::always_inline]] inline double powerFromZero(double x, double y) {
  constexpr double kLeast = 1e-300;
  const double value = power(std::max(x, kLeast), y);
  return x > 0 ? value : 0;
}

inline constexpr double kColorExponent = 0.7;

/// Returns the largest colour distance, 41.276098. It is the HyAB distance of green and blue, to the power 0.7.
inline double largestColorDistance() {
  return power(hyabDistance(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kColorExponent);
}

/// Returns the difference of two Hunt-adjusted colours as an error in [0, 1]. It depends on d, the HyAB distance
/// to the power 0.7. The lower 0.4 of d's range has errors from 0 to 0.95, because the eye distinguishes more
/// there.
/// @param largest  largestColorDistance(), which loops compute once
[[gnu::always_inline]] inline double colorError(const Triple& a, const Triple& b, double largest) {
  constexpr double kKneeValue = 0.95;
  const double knee = 0.4 * largest, d = powerFromZero(hyabDistance(a, b), kColorExponent);
  const double lower = kKneeValue * d / knee,
               upper = kKneeValue + (1 - kKneeValue) * (d - knee) / (largest - knee);
  return d < knee ? lower : upper;
}

}  // namespace poinsot::compare
