// SPDX-License-Identifier: Apache-2.0
#include "core/rational.h"
#include "core/number.h"

#include <fmt/format.h>

#include <numeric>

namespace poinsot::core {
namespace {

constexpr std::int64_t kLargestPart = 1'000'000'000;

std::optional<std::int64_t> parseDigits(std::string_view text) {
  const auto value = parseInteger<std::int64_t>(text);
  return value && text.front() != '-' && *value <= kLargestPart ? value : std::nullopt;
}

std::optional<Rational> reduced(std::int64_t num, std::int64_t den) {
  if (num <= 0 || den <= 0) return std::nullopt;
  const auto divisor = std::gcd(num, den);
  return Rational{num / divisor, den / divisor};
}

std::optional<Rational> parseDecimal(std::string_view whole, std::string_view fraction) {
  std::int64_t den = 1;
  for (std::size_t i = 0; i < fraction.size(); ++i) {
    den *= 10;
    if (den > kLargestPart) return std::nullopt;
  }
  const auto high = parseDigits(whole), low = parseDigits(fraction);
  if (!high || !low || *high > kLargestPart / den) return std::nullopt;
  return reduced(*high * den + *low, den);
}

}  // namespace

std::string toString(const Rational& r) { return fmt::format("{}/{}", r.num, r.den); }

std::optional<Rational> parseRational(std::string_view text) {
  if (const auto slash = text.find('/'); slash != std::string_view::npos) {
    const auto num = parseDigits(text.substr(0, slash)), den = parseDigits(text.substr(slash + 1));
    return num && den ? reduced(*num, *den) : std::nullopt;
  }
  if (const auto dot = text.find('.'); dot != std::string_view::npos)
    return parseDecimal(text.substr(0, dot), text.substr(dot + 1));
  const auto whole = parseDigits(text);
  return whole ? reduced(*whole, 1) : std::nullopt;
}

}  // namespace poinsot::core
