// SPDX-License-Identifier: Apache-2.0
#include "compare/flip_stages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::compare {

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
