// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/difference.h"

namespace poinsot {

/// Rule by which a program compares golden images, with its usual limits.
struct ComparisonRule {
  std::string name;
  std::function<bool(const image::Image& reference, const image::Image& test)> fails;
};

/// Returns rules of other programs, from their documentation, and poinsot's rule at the end: idiff as Blender
/// calls it (-fail 0.016 -failpercent 1), the RMS of pytest-mpl (2) and of dm_control (10), pixelmatch (YIQ,
/// threshold 0.1, any pixel; without its exception for smooth edges), pygfx's largest difference (3), and the mean
/// of FLIP alone (1e-3).
const std::vector<ComparisonRule>& comparisonRules();

}  // namespace poinsot
