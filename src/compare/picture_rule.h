// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/ignore_mask.h"
#include "compare/near_rule.h"

namespace poinsot::compare {

/// Permitted difference between a picture and its reference.
struct PictureRule {
  NearRule limits = {};
  std::vector<image::PixelRect> ignore = {};
  std::filesystem::path mask = {};              ///< PNG whose painted pixels are not compared; empty for none
  std::optional<image::AnyImage> painted = {};  ///< mask as a picture in memory, used like `mask`
  std::string reason = {};                      ///< why this rule permits more than the default
};

/// Limit of a rule, with its notation on command lines and in golden.toml. A limit is a range from 0, such as
/// "0-2" or "0-1e-3", so that an identical picture always passes. The limit on pixels is a number or a percentage,
/// such as "0-20" or "0-0.5%".
struct RuleLimit {
  const char* key;
  const char* option;  ///< option of `diff`
  const char* form;    ///< "0-N"
  const char* help;
  /// Parses a word such as "0-2" and sets the limit.
  /// @throws core::Error(kUsage) with `name`, the word and the expected notation
  void (*set)(NearRule& limits, std::string_view name, std::string_view word);
};
std::span<const RuleLimit> ruleLimits();

std::string ruleNames();
/// Returns the limits of a rule by its name, such as "near".
/// @throws core::Error(kUsage) with `name`, the word and the known names
NearRule namedLimits(std::string_view name, std::string_view word);

/// Returns the box with the given left, top, width and height in pixels.
/// @throws core::Error(kUsage) with `name`, unless all numbers are integers, left and top are at least 0, and
///   width and height are at least 1
image::PixelRect ignoredBox(std::string_view name, std::span<const double> leftTopWidthHeight);
/// Parses a box given as "x,y,w,h" in pixels. @throws core::Error(kUsage) if the box is invalid
image::PixelRect ignoredBox(std::string_view name, std::string_view word);

/// Checks that some pair of pictures can exceed the limits.
/// @param pixels  number of pixels of the pictures, if known
/// @throws core::Error(kUsage) with `name` if every pair would pass
void expectCanRefuse(const NearRule& limits, std::string_view name, std::optional<std::int64_t> pixels = {});

/// Returns the mask of the pixels that a rule ignores; nullopt if it ignores none.
/// @throws core::Error(kUsage) if a box lies outside the picture, the mask has another size, or nothing is left to
///   compare; core::Error(kIo) if the mask cannot be read
std::optional<IgnoreMask> ignoreMaskOf(const PictureRule& rule, image::PixelSize size);

}  // namespace poinsot::compare
