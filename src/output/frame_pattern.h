// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::output {

/// File names of a numbered sequence: "dir/name_{frame}.png" or "dir/name_{frame:05}.png" (at least 5 digits).
class FramePattern {
 public:
  /// Returns whether a text is meant as a pattern, because it has a brace.
  static bool isPattern(std::string_view text);

  /// @throws core::Error(kUsage) unless the file name (not the folder) has exactly one {frame} or {frame:0N}, with
  /// N from 1 to 9.
  explicit FramePattern(const std::string& text);

  /// @pre k >= 0.
  std::filesystem::path path(std::int64_t k) const;
  /// Returns the k whose path() has this file name; nullopt if there is none.
  std::optional<std::int64_t> frameOf(const std::string& name) const;

 private:
  std::string before_;
  std::string after_;
  int digits_ = 1;
};

}  // namespace poinsot::output
