// SPDX-License-Identifier: Apache-2.0
#include "compare/flip_stages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace poinsot::compare {

namespace {

using Matrix = std::array<Triple, 3>;

// Matrix from linear sRGB to XYZ. The entries are fractions, so that the sum of the columns is exactly the white
// point.
constexpr Matrix kXyzFromRgb = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

constexpr Triple product(const Matrix& m, const Triple& v) {
  Triple r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

constexpr Triple kWhite = product(kXyzFromRgb, {1, 1, 1});

/// Matrix from linear sRGB to XYZ, scaled so that white is (1, 1, 1).
constexpr Matrix kRelativeXyzFromRgb = [] {
  Matrix m = kXyzFromRgb;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& entry : m[i]) entry /= kWhite[i];
  return m;
}();

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

constexpr Matrix kRgbFromRelativeXyz = inverse(kRelativeXyzFromRgb);

/// Returns the cube root of a positive number to two units in the last place. Takes half as long as std::cbrt,
/// which took a third of FLIP's run time. The first guess divides the exponent by 3 and is within 6 %. Each Halley
/// step cubes the relative error.
double cubeRoot(double t) {
  constexpr std::uint64_t kThirdOfOne = 0x2A9F7893'00000000;
  double root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(t) / 3 + kThirdOfOne);
  for (int step = 0; step < 3; ++step) {
    const double cube = root * root * root;
    root *= (cube + 2 * t) / (2 * cube + t);
  }
  return root;
}

}  // namespace

double linearLight(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Triple opponentColor(const Triple& rgb) {
  const auto [x, y, z] = product(kRelativeXyzFromRgb, rgb);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple rgbOfOpponent(const Triple& yCxCz) {
  const double y = (yCxCz[0] + 16) / 116, x = y + yCxCz[1] / 500, z = y - yCxCz[2] / 200;
  Triple rgb = product(kRgbFromRelativeXyz, {x, y, z});
  for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
  return rgb;
}

Triple huntLab(const Triple& rgb) {
  constexpr double kDelta = 6.0 / 29;
  const auto f = [](double t) {
    return t > kDelta * kDelta * kDelta ? cubeRoot(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const Triple xyz = product(kRelativeXyzFromRgb, rgb);
  const double fx = f(xyz[0]), fy = f(xyz[1]), fz = f(xyz[2]);
  const double lightness = 116 * fy - 16;
  return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

double hyabDistance(const Triple& a, const Triple& b) {
  const double da = a[1] - b[1], db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

namespace {

constexpr double kExponent = 0.7, kKnee = 0.4, kKneeValue = 0.95;

}  // namespace

double largestColorDistance() {
  static const double largest = std::pow(hyabDistance(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kExponent);
  return largest;
}

double colorError(const Triple& a, const Triple& b) {
  const double distance = hyabDistance(a, b);
  if (distance == 0) return 0;
  const double c = std::pow(distance, kExponent), knee = kKnee * largestColorDistance();
  if (c < knee) return kKneeValue * c / knee;
  return kKneeValue + (1 - kKneeValue) * (c - knee) / (largestColorDistance() - knee);
}

namespace {

constexpr double kPi = std::numbers::pi;

template <class F>
std::vector<double> sampled(int radius, F f) {
  std::vector<double> half;
  for (int i = 0; i <= radius; ++i) half.push_back(f(i));
  return half;
}

/// Gaussian term of a contrast sensitivity, with weight a and width b; b is in squared degrees.
struct Gaussian {
  double a = 0;
  double b = 0;
};

int sensitivityRadius(double pixelsPerDegree) {
  constexpr double kWidest = 0.04;  // largest width b of all channels
  return static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixelsPerDegree));
}

/// Returns the terms of a channel's filter. The factor √(π/b) belongs to the 2D Gaussian, so it is applied once,
/// and not once per direction.
std::vector<SensitivityPart> partsOf(const std::vector<Gaussian>& gaussians, double pixelsPerDegree) {
  std::vector<SensitivityPart> parts;
  double total = 0;
  for (const Gaussian& gaussian : gaussians) {
    Kernel profile(Kernel::Parity::kEven, sampled(sensitivityRadius(pixelsPerDegree), [&](int i) {
                     const double d = i / pixelsPerDegree;
                     return std::exp(-kPi * kPi * d * d / gaussian.b);
                   }));
    const double weight = gaussian.a * std::sqrt(kPi / gaussian.b);
    total += weight * profile.sum() * profile.sum();
    parts.push_back({std::move(profile), weight});
  }
  for (SensitivityPart& part : parts) part.weight /= total;
  return parts;
}

double featureWidth(double pixelsPerDegree) {
  constexpr double kFeatureWidth_deg = 0.082;
  return 0.5 * kFeatureWidth_deg * pixelsPerDegree;
}

int featureRadius(double pixelsPerDegree) {
  return static_cast<int>(std::ceil(3 * featureWidth(pixelsPerDegree)));
}

double positiveSum(const Kernel& kernel) {
  double sum = 0;
  for (int i = -kernel.radius(); i <= kernel.radius(); ++i) sum += std::max(kernel.at(i), 0.0);
  return sum;
}

double negativeSum(const Kernel& kernel) {
  double sum = 0;
  for (int i = -kernel.radius(); i <= kernel.radius(); ++i) sum += std::min(kernel.at(i), 0.0);
  return sum;
}

/// Returns a kernel with scaled weights: positive weights sum to 1, negative weights to -1.
Kernel balanced(Kernel::Parity parity, std::vector<double> half) {
  const Kernel kernel(parity, half);
  const double positive = positiveSum(kernel), negative = -negativeSum(kernel);
  for (double& weight : half) weight /= weight > 0 ? positive : negative;
  return {parity, std::move(half)};
}

}  // namespace

std::array<std::vector<SensitivityPart>, 3> contrastSensitivity(double pixelsPerDegree) {
  return {partsOf({{1, 0.0047}}, pixelsPerDegree), partsOf({{1, 0.0053}}, pixelsPerDegree),
          partsOf({{34.1, 0.04}, {13.5, 0.025}}, pixelsPerDegree)};
}

FeatureKernels featureKernels(double pixelsPerDegree) {
  const double sigma = featureWidth(pixelsPerDegree);
  const int radius = featureRadius(pixelsPerDegree);
  const auto gauss = [&](int i) { return std::exp(-i * i / (2 * sigma * sigma)); };
  const Kernel bell(Kernel::Parity::kEven, sampled(radius, gauss));
  return {bell.scaled(1 / bell.sum()),
          balanced(Kernel::Parity::kOdd, sampled(radius, [&](int i) { return -i * gauss(i); })),
          balanced(Kernel::Parity::kEven,
                   sampled(radius, [&](int i) { return (i * i / (sigma * sigma) - 1) * gauss(i); }))};
}

int flipRadius(double pixelsPerDegree) {
  return std::max(sensitivityRadius(pixelsPerDegree), featureRadius(pixelsPerDegree));
}

}  // namespace poinsot::compare
