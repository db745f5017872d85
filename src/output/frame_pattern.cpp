// SPDX-License-Identifier: Apache-2.0
#include "output/frame_pattern.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "core/error.h"
#include "core/expect.h"
#include "core/text.h"

namespace poinsot::output {
namespace {

[[noreturn]] void refusePattern(std::string_view text, std::string_view reason) {
  throw core::usageError(
      fmt::format("{}: {}; write one {{frame}} or {{frame:05}} in the file name, as in name_{{frame:05}}.png",
                  core::printable(text), reason));
}

/// Returns the number of digits that a field requests: 1 for "frame", N for "frame:0N", 0 for any other text.
int digitsOf(std::string_view field) {
  if (field == "frame") return 1;
  const bool padded = field.size() == 8 && field.starts_with("frame:0") && field[7] >= '1' && field[7] <= '9';
  return padded ? field[7] - '0' : 0;
}

}  // namespace

bool FramePattern::isPattern(std::string_view text) { return text.find_first_of("{}") != std::string_view::npos; }

FramePattern::FramePattern(const std::string& text) {
  const auto open = text.find('{'), close = text.find('}');
  if (open == std::string::npos || close == std::string::npos || close < open)
    refusePattern(text, "no frame number");
  before_ = text.substr(0, open);
  after_ = text.substr(close + 1);
  digits_ = digitsOf(std::string_view(text).substr(open + 1, close - open - 1));
  if (digits_ == 0)
    refusePattern(text, "not a frame number: " + core::printable(text.substr(open, close - open + 1)));
  if (isPattern(before_) || isPattern(after_)) refusePattern(text, "more than one pair of braces");
  if (after_.find('/') != std::string::npos) refusePattern(text, "the frame number is in the folder's name");
}

std::filesystem::path FramePattern::path(std::int64_t k) const {
  POINSOT_EXPECT(k >= 0);
  return fmt::format("{}{:0{}}{}", before_, k, digits_, after_);
}

std::optional<std::int64_t> FramePattern::frameOf(const std::string& name) const {
  const std::string before = std::filesystem::path(before_).filename();
  if (name.size() <= before.size() + after_.size() || !name.starts_with(before)) return std::nullopt;
  const char* begin = name.data() + before.size();
  std::int64_t k = -1;
  const auto read = std::from_chars(begin, name.data() + name.size() - after_.size(), k);
  const bool isOne = read.ec == std::errc() && k >= 0 && path(k).filename() == name;
  return isOne ? std::optional(k) : std::nullopt;
}

}  // namespace poinsot::output
