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

/// Limits up to which two pictures count as near. The defaults suit pictures of one scene from two driver versions
/// or processors. All limits must hold, because each limit alone is too weak: a missing facet has a small mean
/// difference, and a picture that is one level brighter everywhere has a small maximum difference.
struct NearRule {
  double maxAbs = 2;  ///< largest difference of a channel, in 1/255
  double differingShare = 0.005;
  std::optional<std::int64_t> differingPixels = {};  ///< most differing pixels; replaces differingShare
  double flipMean = 1e-3;
  double flipMax = 0.05;
  double level = 0;  ///< pixels count only if they differ by more than this, in 1/255

  /// Reports whether some pair of pictures can exceed the limits.
  /// @param pixels  number of pixels of a picture, if known
  bool canRefuse(std::optional<std::int64_t> pixels = {}) const;
};

struct NamedRule {
  std::string_view name;
  NearRule rule;
};

/// Returns the rules that have a name.
/// - "same": no pixel may differ.
/// - "near", the default: another version of the driver may change a few pixels by one or two levels.
/// - "other_driver": another driver may draw edges differently. The limits were measured on Mesa's softpipe and on
///   simulated drivers. docs/golden.md lists the errors that each rule still detects.
const std::vector<NamedRule>& namedRules();

Verdict verdict(const ImageDifference& difference, const NearRule& rule = {});

/// Describes the exceeded limits, such as "largest difference 133 (limit 2)" or "FLIP max 0.697 (limit 0.05)".
/// Returns an empty list if all limits hold.
std::vector<std::string> excesses(const ImageDifference& difference, const NearRule& rule);

/// Returns by how much a difference exceeds a rule, for sorting. The result is the sum of ln(figure / limit) over
/// the exceeded limits, or 0 if all limits hold. A measure that has reached its maximum, such as the largest
/// difference, leaves the order to the other measures.
double distanceBeyond(const ImageDifference& difference, const NearRule& rule);

}  // namespace poinsot::compare
