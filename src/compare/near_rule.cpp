// SPDX-License-Identifier: Apache-2.0
#include "compare/near_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot::compare {
namespace {

struct Limit {
  std::string name;
  double value, most;
  const char* unit = "";
};

std::string figure(double value) {
  return value < 1000 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

std::string pixelsName(const NearRule& rule) {
  return rule.level == 0 ? "differing pixels" : fmt::format("pixels beyond level {}", figure(rule.level));
}

Limit pixelsLimit(const ImageDifference& d, const NearRule& rule) {
  if (!rule.differingPixels) return {pixelsName(rule), 100 * d.countedShare(), 100 * rule.differingShare, " %"};
  return {pixelsName(rule), static_cast<double>(d.countedPixels), static_cast<double>(*rule.differingPixels)};
}

std::vector<Limit> limitsOf(const ImageDifference& d, const NearRule& rule) {
  return {{"largest difference", d.maxAbs, rule.maxAbs},
          pixelsLimit(d, rule),
          {"FLIP mean", d.flip.mean, rule.flipMean},
          {"FLIP max", d.flip.max, rule.flipMax}};
}

}  // namespace

bool NearRule::canRefuse(std::optional<std::int64_t> pixels) const {
  constexpr double kMostDifference = 255;
  const bool countsPixels = differingPixels ? !pixels || *differingPixels < *pixels : differingShare < 1;
  return maxAbs < kMostDifference || countsPixels || flipMean < 1 || flipMax < 1;
}

const std::vector<NamedRule>& namedRules() {
  static const std::vector<NamedRule> rules = {
      {"same", {.maxAbs = 0, .differingShare = 0, .flipMean = 0, .flipMax = 0}},
      {"near", {}},
      {"other_driver", {.maxAbs = 255, .differingShare = 1, .flipMean = 0.02, .flipMax = 0.4}}};
  return rules;
}

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return "identical";
    case Verdict::kNear:
      return "near";
    case Verdict::kDifferent:
      return "different";
  }
  return "";
}

Verdict verdict(const ImageDifference& d, const NearRule& rule) {
  if (d.differingPixels == 0) return Verdict::kIdentical;
  return excesses(d, rule).empty() ? Verdict::kNear : Verdict::kDifferent;
}

std::vector<std::string> excesses(const ImageDifference& d, const NearRule& rule) {
  std::vector<std::string> texts;
  for (const auto& [name, value, most, unit] : limitsOf(d, rule))
    if (!(value <= most))
      texts.push_back(fmt::format("{} {}{} (limit {}{})", name, figure(value), unit, figure(most), unit));
  return texts;
}

double distanceBeyond(const ImageDifference& d, const NearRule& rule) {
  constexpr double kLeast = 1e-6;  // divisor if the limit is 0
  double sum = 0;
  for (const Limit& limit : limitsOf(d, rule))
    if (limit.value > limit.most) sum += std::log(limit.value / std::max(limit.most, kLeast));
  return sum;
}

}  // namespace poinsot::compare
