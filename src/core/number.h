// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace poinsot::core {

/// Parses a decimal number of any length: "1", "-3.5", "+1e9", "inf", "nan". Returns the nearest double, or
/// infinity or zero if the number is out of range. Returns nullopt if the text is not a number.
std::optional<double> parseNumber(std::string_view text);

/// Parses a whole number such as "-12". Returns nullopt for other text, for a number with a plus sign, and for a
/// number out of the type's range.
template <std::integral Integer>
std::optional<Integer> parseInteger(std::string_view text) {
  Integer value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Appends the shortest decimal that reads back as the same double. Zero has no sign.
void appendNumber(std::string& text, double value);

}  // namespace poinsot::core
