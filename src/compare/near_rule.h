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

std::string_view toString(Verdict verdict);

/// Limits for two pictures of one scene from two driver versions or processors. All limits must hold, because each
/// alone is too weak: a missing facet has a small mean, and a whole picture one level brighter has a small
/// maximum.
struct NearRule {
  double maxAbs = 2;  ///< largest difference of a channel, in 1/255
  double differingShare = 0.005;
  std::optional<std::int64_t> differingPixels = {};  ///< number of pixels; replaces differingShare
  double flipMean = 1e-3;
  double flipMax = 0.05;
  double level = 0;  ///< in 1/255; pixels that differ by no more do not count as differing

  /// Reports whether any pair of pictures can exceed the limits. @param pixels  number of pixels of a picture, if
  /// known
  bool canRefuse(std::optional<std::int64_t> pixels = {}) const;
};

struct NamedRule {
  std::string_view name;
  NearRule rule;
};

/// Returns the named rules. "same": no pixel differs. "near", the default: another version of the driver moved a
/// few pixels by one or two levels. "other_driver": another driver rasterises edges differently; measured on
/// Mesa's softpipe and on simulated drivers (docs/golden.md lists what each rule still catches).
const std::vector<NamedRule>& namedRules();

Verdict verdict(const ImageDifference& difference, const NearRule& rule = {});

/// Describes the exceeded limits: "largest difference 133 (limit 2)", "FLIP max 0.697 (limit 0.05)". Returns an
/// empty list if all limits hold.
std::vector<std::string> excesses(const ImageDifference& difference, const NearRule& rule);

/// Returns how far a difference exceeds a rule: the sum of ln(figure / limit) over the exceeded limits, 0 if all
/// hold. For measures that saturate, such as the largest difference, the other measures thus decide the order.
double distanceBeyond(const ImageDifference& difference, const NearRule& rule);

}  // namespace poinsot::compare
