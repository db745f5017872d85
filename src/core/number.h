// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace poinsot::core {

/// The double nearest to a decimal number, however many digits it has: "1", "-3.5", "+1e9", "inf", "nan". What is
/// too large is infinite, what is too small is zero. Empty if the whole text is no number.
std::optional<double> parseNumber(std::string_view text);

/// Appends the shortest decimal number that reads back as this very double; zero has no sign.
void appendNumber(std::string& text, double value);

}  // namespace poinsot::core
