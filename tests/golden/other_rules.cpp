// SPDX-License-Identifier: Apache-2.0
#include "golden/other_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "compare/near_rule.h"

namespace poinsot {
namespace {

using image::Image;

/// Function of a pixel of each picture, which reads the first three channels.
using PixelTest = std::function<bool(const std::uint8_t* p, const std::uint8_t* q)>;

double shareOfPixels(const Image& a, const Image& b, const PixelTest& counts) {
  std::int64_t count = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x) count += counts(a.at(x, y), b.at(x, y)) ? 1 : 0;
  return static_cast<double>(count) / (static_cast<double>(a.size.width) * a.size.height);
}

int largestDifference(const std::uint8_t* p, const std::uint8_t* q) {
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/// Difference by Kotsarenko and Ramos (2010), as in pixelmatch.
bool isFarInYiq(const std::uint8_t* p, const std::uint8_t* q) {
  const auto d = [&](double r, double g, double b) {
    return r * (p[0] - q[0]) + g * (p[1] - q[1]) + b * (p[2] - q[2]);
  };
  const double y = d(0.29889531, 0.58662247, 0.11448223), i = d(0.59597799, -0.27417610, -0.32180189),
               v = d(0.21147017, -0.52261711, 0.31114694);
  constexpr double kLargest = 35215, kThreshold = 0.1;
  return 0.5053 * y * y + 0.299 * i * i + 0.1957 * v * v > kLargest * kThreshold * kThreshold;
}

double rms(const Image& a, const Image& b) { return compare::compare(a, b).difference.rmse; }

bool failsOurs(const Image& a, const Image& b) {
  return compare::verdict(compare::compare(a, b).difference) == compare::Verdict::kDifferent;
}

}  // namespace

const std::vector<ComparisonRule>& comparisonRules() {
  static const std::vector<ComparisonRule> rules = {
      {"Blender",
       [](const Image& a, const Image& b) {
         return shareOfPixels(a, b, [](const auto* p, const auto* q) {
                  return largestDifference(p, q) > 0.016 * 255;
                }) > 0.01;
       }},
      {"RMS 2", [](const Image& a, const Image& b) { return rms(a, b) > 2; }},
      {"RMS 10", [](const Image& a, const Image& b) { return rms(a, b) > 10; }},
      {"pixelmatch", [](const Image& a, const Image& b) { return shareOfPixels(a, b, isFarInYiq) > 0; }},
      {"largest 3",
       [](const Image& a, const Image& b) {
         return shareOfPixels(a, b, [](const auto* p, const auto* q) { return largestDifference(p, q) > 3; }) > 0;
       }},
      {"FLIP's mean", [](const Image& a, const Image& b) { return compare::flip(a, b).mean() > 1e-3; }},
      {"poinsot", failsOurs},
  };
  return rules;
}

}  // namespace poinsot
