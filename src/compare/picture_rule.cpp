// SPDX-License-Identifier: Apache-2.0
#include "compare/picture_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "image/png_file.h"

namespace poinsot::compare {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view word, std::string_view why) {
  throw core::usageError(fmt::format("{} '{}': {}", name, core::printable(word), why));
}

/// Parses "0-N" or "0-N%" and returns N. @param most  largest allowed N
double upperEnd(std::string_view name, std::string_view word, double most) {
  const std::string_view unit = word.ends_with('%') ? "%" : "";
  const std::string_view range = word.substr(0, word.size() - unit.size());
  if (!range.starts_with("0-"))
    refuse(name, word,
           core::parseNumber(range) ? fmt::format("write 0-{}: a limit is a range from 0", core::printable(word))
                                    : "a limit is a range from 0, such as 0-2");
  const auto value = core::parseNumber(range.substr(2));
  if (!value || !(*value >= 0) || !(*value <= most))
    refuse(name, word, fmt::format("the end of the range must be a number from 0 to {:g}", most));
  return *value;
}

void expectNoShare(std::string_view name, std::string_view word) {
  if (word.ends_with('%')) refuse(name, word, "% is allowed for pixels only");
}

void setMaxDifference(NearRule& limits, std::string_view name, std::string_view word) {
  expectNoShare(name, word);
  limits.maxAbs = upperEnd(name, word, 255);
}

void setDifferingPixels(NearRule& limits, std::string_view name, std::string_view word) {
  if (word.ends_with('%')) {
    limits.differingShare = upperEnd(name, word, 100) / 100;
    limits.differingPixels.reset();
    return;
  }
  const double count = upperEnd(name, word, 1e9);
  if (count != std::floor(count)) refuse(name, word, "must be a whole number of pixels, or a share with %");
  limits.differingPixels = static_cast<std::int64_t>(count);
}

void setFlipMean(NearRule& limits, std::string_view name, std::string_view word) {
  expectNoShare(name, word);
  limits.flipMean = upperEnd(name, word, 1);
}

void setFlipMax(NearRule& limits, std::string_view name, std::string_view word) {
  expectNoShare(name, word);
  limits.flipMax = upperEnd(name, word, 1);
}

void setLevel(NearRule& limits, std::string_view name, std::string_view word) {
  constexpr double kMost = 254;
  const auto value = core::parseNumber(word);
  if (!value || !(*value >= 0) || !(*value <= kMost))
    refuse(name, word,
           fmt::format("must be a number from 0 to {:g}; differences up to this level do not count", kMost));
  limits.level = *value;
}

bool isWhole(double value) { return value == std::floor(value) && std::abs(value) <= 1e6; }

/// Adds the painted pixels of a mask. @param name  name of the mask for messages
void addMask(IgnoreMask& mask, const image::AnyImage& painted, const std::string& name) {
  const image::PixelSize size = std::visit([](const auto& p) { return p.size; }, painted);
  if (size != mask.size())
    throw core::usageError(fmt::format("{}: its size is {}x{}; the picture's is {}x{}", name, size.width,
                                       size.height, mask.size().width, mask.size().height));
  mask.add(painted);
}

std::string boxWords(const image::PixelRect& box) {
  return fmt::format("[{}, {}, {}, {}]", box.left, box.top, box.right - box.left, box.bottom - box.top);
}

}  // namespace

std::span<const RuleLimit> ruleLimits() {
  static constexpr std::array<RuleLimit, 5> kLimits = {{
      {"max", "--max", "0-N", "largest difference of a channel, of 255 (default: 0-2)", setMaxDifference},
      {"pixels", "--pixels", "0-N", "differing pixels, a number or a share (default: 0-0.5%)", setDifferingPixels},
      {"flip_mean", "--flip-mean", "0-N", "mean of FLIP (default: 0-1e-3)", setFlipMean},
      {"flip_max", "--flip-max", "0-N", "largest FLIP of a pixel (default: 0-0.05)", setFlipMax},
      {"level", "--level", "N", "pixels that differ by at most N of 255 do not count in pixels (default: 0)",
       setLevel},
  }};
  return kLimits;
}

std::string ruleNames() {
  std::vector<std::string_view> names;
  for (const NamedRule& known : namedRules()) names.push_back(known.name);
  return core::joined(names, ", ");
}

NearRule namedLimits(std::string_view name, std::string_view word) {
  for (const NamedRule& known : namedRules())
    if (known.name == word) return known.rule;
  refuse(name, word, "unknown rule; known rules: " + ruleNames());
}

image::PixelRect ignoredBox(std::string_view name, std::span<const double> numbers) {
  constexpr const char* kForm = "write x, y, width and height in pixels from the top left, such as 10,20,300,40";
  if (numbers.size() != 4 || !std::ranges::all_of(numbers, isWhole))
    throw core::usageError(fmt::format("{}: {}", name, kForm));
  const auto whole = [&](std::size_t i) { return static_cast<int>(numbers[i]); };
  if (whole(0) < 0 || whole(1) < 0 || whole(2) < 1 || whole(3) < 1)
    throw core::usageError(fmt::format("{}: x and y must be at least 0, width and height at least 1", name));
  return {whole(0), whole(1), whole(0) + whole(2), whole(1) + whole(3)};
}

image::PixelRect ignoredBox(std::string_view name, std::string_view word) {
  std::vector<double> numbers;
  for (std::size_t from = 0; from <= word.size();) {
    const std::size_t comma = std::min(word.find(',', from), word.size());
    numbers.push_back(core::parseNumber(word.substr(from, comma - from)).value_or(NAN));
    from = comma + 1;
  }
  return ignoredBox(fmt::format("{} '{}'", name, core::printable(word)), numbers);
}

void expectCanRefuse(const NearRule& limits, std::string_view name, std::optional<std::int64_t> pixels) {
  if (limits.canRefuse(pixels)) return;
  const std::string many = pixels ? fmt::format(" of {} pixels", *pixels) : "";
  throw core::usageError(fmt::format("{}: every picture{} would pass; lower at least one limit", name, many));
}

std::optional<IgnoreMask> ignoreMaskOf(const PictureRule& rule, image::PixelSize size) {
  if (rule.ignore.empty() && rule.mask.empty() && !rule.painted) return std::nullopt;
  IgnoreMask mask(size);
  for (const image::PixelRect& box : rule.ignore) {
    if (box.left >= size.width || box.top >= size.height)
      throw core::usageError(fmt::format("ignore {}: outside of the picture, whose size is {}x{}", boxWords(box),
                                         size.width, size.height));
    mask.add(box);
  }
  if (!rule.mask.empty())
    addMask(mask, image::readPngAsStored(rule.mask).picture, "mask " + core::printable(rule.mask.native()));
  if (rule.painted) addMask(mask, *rule.painted, "mask");
  if (mask.comparedPixels() == 0)
    throw core::usageError("the ignored places cover the whole picture: nothing is left to compare");
  return mask;
}

}  // namespace poinsot::compare
