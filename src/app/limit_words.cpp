// SPDX-License-Identifier: Apache-2.0
#include "app/limit_words.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/trajectory_number.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view word, std::string_view why) {
  throw core::Error(core::ErrorKind::kUsage, fmt::format("{} '{}': {}", name, core::printable(word), why));
}

/// The upper end of "0-N". @param most  the largest that makes sense
double upperEnd(std::string_view name, std::string_view word, std::string_view rangeText, double most) {
  if (!rangeText.starts_with("0-"))
    refuse(name, word,
           parseNumber(rangeText)
               ? fmt::format("write 0-{}: a limit is a range from 0", core::printable(rangeText))
               : "a limit is a range from 0, such as 0-2");
  const auto value = parseNumber(rangeText.substr(2));
  if (!value || !(*value >= 0) || !(*value <= most))
    refuse(name, word, fmt::format("the end of the range is a number from 0 to {:g}", most));
  return *value;
}

}  // namespace

void setMaxDifference(image::NearRule& rule, std::string_view name, std::string_view word) {
  rule.maxAbs = upperEnd(name, word, word, 255);
}

void setDifferingPixels(image::NearRule& rule, std::string_view name, std::string_view word) {
  if (word.ends_with('%')) {
    rule.differingShare = upperEnd(name, word, word.substr(0, word.size() - 1), 100) / 100;
    rule.differingPixels.reset();
    return;
  }
  const double count = upperEnd(name, word, word, 1e9);
  if (count != std::floor(count)) refuse(name, word, "a whole number of pixels, or a share with %");
  rule.differingPixels = static_cast<std::int64_t>(count);
}

void setFlipMean(image::NearRule& rule, std::string_view name, std::string_view word) {
  rule.flipMean = upperEnd(name, word, word, 1);
}

void setFlipMax(image::NearRule& rule, std::string_view name, std::string_view word) {
  rule.flipMax = upperEnd(name, word, word, 1);
}

}  // namespace poinsot::app
