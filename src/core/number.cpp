// SPDX-License-Identifier: Apache-2.0
#include "core/number.h"

#include <array>
#include <charconv>
#include <cstdlib>

namespace poinsot::core {

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);  // from_chars rejects '+'
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || status == std::errc::invalid_argument) return std::nullopt;
  // The number is out of range. std::strtod returns infinity or zero, as needed. The locale is always "C".
  return status == std::errc() ? value : std::strtod(std::string(text).c_str(), nullptr);
}

void appendNumber(std::string& text, double value) {
  std::array<char, 32> digits;              // longest number: 24 characters, as in -2.2250738585072014e-308
  const double unsignedZero = value + 0.0;  // turns -0 into 0
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), unsignedZero);
  text.append(digits.data(), written.ptr);
}

}  // namespace poinsot::core
