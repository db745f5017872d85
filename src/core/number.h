// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace poinsot::core {

/// The double nearest to a decimal number, however many digits it has: "1", "-3.5", "+1e9", "inf", "nan". What is
/// too large is infinite, what is too small is zero. Empty if the whole text is no number.
std::optional<double> parseNumber(std::string_view text);

/// The whole number that the whole text is, "-12"; empty for any other text, a plus sign, and a number that the
/// type does not hold.
template <std::integral Integer>
std::optional<Integer> parseInteger(std::string_view text) {
  Integer value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Appends the shortest decimal number that reads back as this very double; zero has no sign.
void appendNumber(std::string& text, double value);

}  // namespace poinsot::core
