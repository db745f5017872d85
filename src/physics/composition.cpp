// SPDX-License-Identifier: Apache-2.0
#include "physics/composition.h"

#include <cstddef>

// Compositions of splitting steps. Their orders were verified on the heavy top
// (tests/physics/driven_order_test.cpp). Coefficients that follow from the others are computed, so that sums are
// exact to the last bit.

namespace poinsot::physics {
namespace {

/// Appends the mirrored list: x y z becomes x y z z y x, or x y z y x if z is the centre.
std::vector<double> mirrored(std::vector<double> half, bool centre) {
  for (std::size_t i = half.size() - (centre ? 1 : 0); i-- > 0;) half.push_back(half[i]);
  return half;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

/// Returns the running sums of a palindrome whose sum is 1. The second half of the sums is computed by symmetry,
/// and the last sum is exactly 1.
std::vector<double> cumulated(const std::vector<double>& parts) {
  const std::size_t n = parts.size();
  std::vector<double> ends(n, 1.0);
  double total = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    total += parts[i];
    ends[i] = i < n / 2 ? total : 1 - ends[n - 2 - i];
  }
  return ends;
}

/// Completes `half` to a palindrome whose sum is 1, and returns its running sums. The missing value becomes the
/// centre of the palindrome, or its innermost pair.
std::vector<double> palindrome(std::vector<double> half, bool centre) {
  half.push_back(centre ? 1 - 2 * sum(half) : 0.5 - sum(half));
  return cumulated(mirrored(half, centre));
}

/// Creates a composition of Strang steps: half a kick, a drift, half a kick. Kicks that meet are merged.
/// @param drifts  end of each drift, as a fraction of the step
Composition ofSymmetricSteps(const char* name, int order, const std::vector<double>& drifts) {
  Composition composition{name, order, true, drifts, {}};
  double begin = 0;
  for (const double end : drifts) {
    composition.kicks.push_back(0.5 * (begin + end));
    begin = end;
  }
  return composition;
}

/// Creates a Runge-Kutta-Nyström composition from the first halves of its drifts and kicks.
/// @param centralDrift  true if the central flow is a drift, false if it is a kick
Composition nystrom(const char* name, int order, const std::vector<double>& drifts,
                    const std::vector<double>& kicks, bool centralDrift) {
  Composition composition{name, order, false, palindrome(drifts, centralDrift), palindrome(kicks, !centralDrift)};
  composition.kicks.pop_back();
  return composition;
}

}  // namespace

const Composition& strang2() {
  static const Composition composition = ofSymmetricSteps("Strang splitting", 2, {1});
  return composition;
}

const Composition& nystrom4() {
  static const Composition composition =
      nystrom("Runge-Kutta-Nyström splitting, 6 stages", 4, {0.245298957184271, 0.604872665711080},
              {0.0829844064174052, 0.396309801498368, -0.0390563049223486}, false);
  return composition;
}

const Composition& nystrom6() {
  static const Composition composition = nystrom(
      "Runge-Kutta-Nyström splitting, 11 stages", 6,
      {0.123229775946271, 0.290553797799558, -0.127049212625417, -0.246331761062075, 0.357208872795928},
      {0.0414649985182624, 0.198128671918067, -0.0400061921041533, 0.0752539843015807, -0.0115113874206879}, true);
  return composition;
}

const Composition& kahanLi8() {
  static const Composition composition = ofSymmetricSteps(
      "composition of 17 Strang splittings", 8,
      palindrome({.13020248308889008088, .56116298177510838456, -.38947496264484728641, .15884190655515560090,
                  -.39590389413323757734, .18453964097831570709, .25837438768632204729, .29501172360931029887},
                 true));
  return composition;
}

}  // namespace poinsot::physics
