// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/difference.h"

namespace poinsot::compare {

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
  double level = 0;  ///< in 1/255; pixels that differ by no more do not count as differing pixels

  /// Whether some pair of pictures is beyond the limits. @param pixels  of such pictures, where they are known
  bool canRefuse(std::optional<std::int64_t> pixels = {}) const;
};

/// A rule with a name.
struct NamedRule {
  std::string_view name;
  NearRule rule;
};

/// Rules by name. "same": no pixel differs. "near", the default: another version of the driver moved a few pixels
/// by one or two levels. "other_driver": another driver rasterises edges differently; measured on Mesa's softpipe
/// and on simulated drivers (docs/golden.md has what each rule still catches).
const std::vector<NamedRule>& namedRules();

Verdict verdict(const ImageDifference& difference, const NearRule& rule = {});

/// What is beyond the rule, in words: "largest difference 133 (limit 2)", "FLIP max 0.697 (limit 0.05)". Nothing
/// where all holds.
std::vector<std::string> excesses(const ImageDifference& difference, const NearRule& rule);

/// Orders differences by how far they are beyond a rule: the sum over the limits of ln(figure / limit) where that
/// is positive; 0 where all holds. A measure that saturates, such as the largest difference, so leaves the order
/// to the others.
double distanceBeyond(const ImageDifference& difference, const NearRule& rule);

}  // namespace poinsot::compare
