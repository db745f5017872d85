// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::output {

/// Pattern for the file names of a numbered sequence, such as "dir/name_{frame}.png". "{frame:05}" writes numbers
/// with at least 5 digits.
class FramePattern {
 public:
  /// Returns whether a text is meant as a pattern, that is, whether it has a brace.
  static bool isPattern(std::string_view text);

  /// @throws core::Error(kUsage) unless the file name (not the folder) has exactly one {frame} or {frame:0N}, with
  /// N from 1 to 9.
  explicit FramePattern(const std::string& text);

  /// Returns the file of frame k. @pre k >= 0.
  std::filesystem::path path(std::int64_t k) const;
  /// Returns the number k of the frame that has this file name; nullopt if no frame has it.
  std::optional<std::int64_t> frameOf(const std::string& name) const;

 private:
  std::string before_;
  std::string after_;
  int digits_ = 1;
};

}  // namespace poinsot::output
