// SPDX-License-Identifier: Apache-2.0
#include "color_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::stage {
namespace {

using Matrix = std::array<Lab, 3>;

constexpr Matrix kDeuteranopia = {
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kProtanopia = {
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
// Matrix of IEC 61966-2-1; white is the sum of the columns.
constexpr Matrix kXyzFromRgb = {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};

double row(const Lab& row, const draw::Color& c) { return row[0] * c.r + row[1] * c.g + row[2] * c.b; }

double labRoot(double t) {
  constexpr double kKnee = 6.0 / 29;
  return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4.0 / 29;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }
double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Chroma and hue (degrees, 0 to 360) of a colour with a* stretched by 1 + G.
struct Polar {
  double C, h;
  Polar(const Lab& c, double G) : C(std::hypot((1 + G) * c[1], c[2])) {
    h = C == 0 ? 0 : degrees(std::atan2(c[2], (1 + G) * c[1]));
    if (h < 0) h += 360;
  }
};

double chromaShare(double C) { return std::sqrt(std::pow(C, 7) / (std::pow(C, 7) + std::pow(25.0, 7))); }

double meanHue(const Polar& a, const Polar& b) {
  if (a.C * b.C == 0) return a.h + b.h;
  if (std::abs(a.h - b.h) <= 180) return (a.h + b.h) / 2;
  return (a.h + b.h + (a.h + b.h < 360 ? 360 : -360)) / 2;
}

double hueStep(const Polar& a, const Polar& b) {
  if (a.C * b.C == 0) return 0;
  const double step = b.h - a.h;
  return std::abs(step) <= 180 ? step : step + (step < 0 ? 360 : -360);
}

}  // namespace

draw::Color simulated(const draw::Color& color, Sight sight) {
  if (sight == Sight::kNormal) return color;
  const Matrix& m = sight == Sight::kDeuteranopia ? kDeuteranopia : kProtanopia;
  const auto channel = [&](std::size_t i) { return static_cast<float>(std::clamp(row(m[i], color), 0.0, 1.0)); };
  return {channel(0), channel(1), channel(2)};
}

Lab lab(const draw::Color& color) {
  std::array<double, 3> f{};
  for (std::size_t i = 0; i < 3; ++i)
    f[i] = labRoot(row(kXyzFromRgb[i], color) / row(kXyzFromRgb[i], draw::Color(1)));
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double deltaE76(const Lab& a, const Lab& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// Evaluates equations 2 to 22 of the source, with the source's letters.
double deltaE2000(const Lab& one, const Lab& two) {
  const double Cab = (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2])) / 2;
  const double G = 0.5 * (1 - chromaShare(Cab));
  const Polar a(one, G), b(two, G);
  const double dL = two[0] - one[0], dC = b.C - a.C;
  const double dH = 2 * std::sqrt(a.C * b.C) * std::sin(radians(hueStep(a, b) / 2));
  const double L = (one[0] + two[0]) / 2, C = (a.C + b.C) / 2, h = meanHue(a, b);
  const double T = 1 - 0.17 * std::cos(radians(h - 30)) + 0.24 * std::cos(radians(2 * h)) +
                   0.32 * std::cos(radians(3 * h + 6)) - 0.20 * std::cos(radians(4 * h - 63));
  const double turn = 30 * std::exp(-std::pow((h - 275) / 25, 2));
  const double SL = 1 + 0.015 * (L - 50) * (L - 50) / std::sqrt(20 + (L - 50) * (L - 50));
  const double SC = 1 + 0.045 * C, SH = 1 + 0.015 * C * T;
  const double RT = -std::sin(radians(2 * turn)) * 2 * chromaShare(C);
  const double l = dL / SL, c = dC / SC, d = dH / SH;
  return std::sqrt(l * l + c * c + d * d + RT * c * d);
}

double luminance(const draw::Color& color) { return row(kXyzFromRgb[1], color); }

double contrast(const draw::Color& a, const draw::Color& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

}  // namespace poinsot::stage
