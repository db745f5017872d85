// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

/// A positive fraction in lowest terms: a frame rate such as 30/1 or 30000/1001.
/// Film time is k * den / num, exact; nothing accumulates from frame to frame.
struct Rational {
  std::int64_t num = 0;
  std::int64_t den = 1;

  double value() const { return static_cast<double>(num) / static_cast<double>(den); }
  friend bool operator==(const Rational&, const Rational&) = default;
};

/// "30/1" or "30000/1001".
std::string toString(const Rational& r);

/// Reads "30", "30000/1001" or a short decimal such as "29.97" (= 2997/100); nothing else, no sign, no blanks.
/// Empty when it is none of these, zero, or has a part above 10^9.
std::optional<Rational> parseRational(std::string_view text);

}  // namespace poinsot::core
