// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/difference.h"

namespace poinsot::image {

enum class Verdict { kIdentical, kNear, kDifferent };

/// "identical", "near", "different".
std::string_view toString(Verdict verdict);

/// Limits for two pictures of one scene from two driver versions or processors: all of them must hold, none alone
/// is enough (a missing facet has a small mean, a whole picture one level brighter a small maximum).
struct NearRule {
  double maxAbs = 2;  ///< in 1/255
  double differingShare = 0.005;
  std::optional<std::int64_t> differingPixels = {};  ///< in place of the share
  double flipMean = 1e-3;
  double flipMax = 0.05;
};

Verdict verdict(const ImageDifference& difference, const NearRule& rule = {});

/// What is beyond the rule, in words: "largest difference 133 (limit 2)", "FLIP max 0.697 (limit 0.05)". Nothing
/// where all holds.
std::vector<std::string> excesses(const ImageDifference& difference, const NearRule& rule);

}  // namespace poinsot::image
