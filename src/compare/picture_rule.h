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

/// How far a picture may be from its reference, and where.
struct PictureRule {
  NearRule limits = {};
  std::vector<image::PixelRect> ignore = {};    ///< places that are not compared
  std::filesystem::path mask = {};              ///< PNG whose painted pixels are not compared; empty for none
  std::optional<image::AnyImage> painted = {};  ///< the same of a picture in memory
  std::string reason = {};                      ///< why it may be farther than by default
};

/// A limit as it is written on a command line and in a golden.toml: "0-2", "0-1e-3"; of pixels a number or a
/// share, "0-20", "0-0.5%". Each is a range from 0, so that an identical picture always passes.
struct RuleLimit {
  const char* key;     ///< in a golden.toml
  const char* option;  ///< of `diff`
  const char* form;    ///< "0-N"
  const char* help;
  /// Sets the limit. @throws core::Error(kUsage) with `name` and the word, saying how it is written.
  void (*set)(NearRule& limits, std::string_view name, std::string_view word);
};
std::span<const RuleLimit> ruleLimits();

/// "same, near, other_driver"
std::string ruleNames();
/// The limits of a named rule. @throws core::Error(kUsage) with `name`, the word and the names that there are.
NearRule namedLimits(std::string_view name, std::string_view word);

/// A box of pixels from its left, its top, its width and its height.
/// @throws core::Error(kUsage) with `name` unless they are whole, left and top at least 0, the others at least 1.
image::PixelRect ignoredBox(std::string_view name, std::span<const double> leftTopWidthHeight);
/// The same of "x,y,w,h".
image::PixelRect ignoredBox(std::string_view name, std::string_view word);

/// @throws core::Error(kUsage) with `name` if no picture, or none of so many pixels, could be beyond the limits.
void expectCanRefuse(const NearRule& limits, std::string_view name, std::optional<std::int64_t> pixels = {});

/// The places that a rule leaves out of a picture; nothing where it leaves out none.
/// @throws core::Error(kUsage) if a box lies outside of the picture, the mask has another size, or nothing would
/// be left to compare; core::Error(kIo) if the mask cannot be read.
std::optional<IgnoreMask> ignoreMaskOf(const PictureRule& rule, image::PixelSize size);

}  // namespace poinsot::compare
