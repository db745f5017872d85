// SPDX-License-Identifier: Apache-2.0
#include "image/near_rule.h"

#include <fmt/format.h>

namespace poinsot::image {
namespace {

/// One limit, and how much of it is used.
struct Limit {
  const char* name;
  double value, most;
  const char* unit = "";
};

/// Four digits of a fraction; all of a number of pixels.
std::string figure(double value) {
  return value < 1000 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

std::vector<Limit> limitsOf(const ImageDifference& d, const NearRule& rule) {
  const Limit pixels = rule.differingPixels
                           ? Limit{"differing pixels", static_cast<double>(d.differingPixels),
                                   static_cast<double>(*rule.differingPixels)}
                           : Limit{"differing pixels", 100 * d.differingShare, 100 * rule.differingShare, " %"};
  return {{"largest difference", d.maxAbs, rule.maxAbs},
          pixels,
          {"FLIP mean", d.flip.mean, rule.flipMean},
          {"FLIP max", d.flip.max, rule.flipMax}};
}

}  // namespace

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

}  // namespace poinsot::image
