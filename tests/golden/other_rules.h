// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/difference.h"

namespace poinsot {

/// A rule by which some program tells golden images apart, with its usual limits.
struct ComparisonRule {
  std::string name;
  std::function<bool(const image::Image& reference, const image::Image& test)> fails;
};

/// Those of others, from their documentation, and at the end ours: idiff as Blender calls it (-fail 0.016
/// -failpercent 1), the RMS of pytest-mpl (2) and of dm_control (10), pixelmatch (YIQ, threshold 0.1, any pixel;
/// its exception for smooth edges left out), pygfx's largest difference (3), and the mean of FLIP alone (1e-3).
const std::vector<ComparisonRule>& comparisonRules();

}  // namespace poinsot
