// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::core {

/// Positive fraction in lowest terms, such as a frame rate of 30000/1001 per second. With a fraction, the time of
/// a frame, k * den / num, is exact, so errors do not accumulate from frame to frame.
struct Rational {
  std::int64_t num = 0;
  std::int64_t den = 1;

  double value() const { return static_cast<double>(num) / static_cast<double>(den); }
  friend bool operator==(const Rational&, const Rational&) = default;
};

std::string toString(const Rational& r);

/// Parses "30", "30000/1001" or a short decimal such as "29.97" (2997/100), without a sign or spaces.
/// @returns nullopt for other text, for zero, and if the numerator or denominator exceeds 10^9
std::optional<Rational> parseRational(std::string_view text);

}  // namespace poinsot::core
