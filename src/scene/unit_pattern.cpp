// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/text.h"
#include "scene/unit_names.h"

namespace poinsot::scene {
namespace {

std::string either(const std::vector<std::string>& patterns) {
  return fmt::format("({})", core::joined(patterns, "|"));
}

std::vector<std::string> eachOf(std::string_view words) {
  const auto parts = wordsIn(words);
  return {parts.begin(), parts.end()};
}

/// Returns a regular expression for an optional prefix of a unit, such as "(k|c|m)?"; empty without prefixes.
std::string optionalPrefix(const UnitRow& row, std::string_view Prefix::*spelling) {
  std::vector<std::string> prefixes;
  for (const Prefix& prefix : prefixesOf(row))
    std::ranges::copy(eachOf(prefix.*spelling), std::back_inserter(prefixes));
  return prefixes.empty() ? "" : either(prefixes) + "?";
}

/// Returns regular expressions for all spellings of a unit, such as "(k|c|m)?m" and
/// "(kilo|centi|milli)?(metre|meter)s?".
std::vector<std::string> rowPatterns(const UnitRow& row) {
  std::vector<std::string> patterns = eachOf(row.symbols);
  patterns.front() = optionalPrefix(row, &Prefix::symbols) + patterns.front();
  if (!row.nouns.empty())
    patterns.push_back(fmt::format("{}{}s?", optionalPrefix(row, &Prefix::name), either(eachOf(row.nouns))));
  return patterns;
}

std::string namesPattern(const Exponents& exponents) {
  std::vector<std::string> patterns;
  for (const UnitRow& row : kUnits)
    if (row.unit.exponents == exponents) std::ranges::copy(rowPatterns(row), std::back_inserter(patterns));
  return either(patterns);
}

constexpr const char* kTimes = R"(( +| *(\*|·|⋅|×|\.|-) *))";

constexpr const char* kOver = "( */ *)";

/// Returns a regular expression for a power of a unit, such as "(m|cm)((\^|\*\*)?2|²)".
std::string power(const std::string& names, int exponent) {
  if (exponent == 1) return names;
  constexpr std::string_view kSuperscripts[] = {"¹", "²", "³", "⁴"};
  const auto size = static_cast<std::size_t>(std::abs(exponent));
  return fmt::format(R"({}((\^|\*\*)?{}|{}{}))", names, exponent, exponent < 0 ? "⁻" : "",
                     kSuperscripts[size - 1]);
}

/// Returns a regular expression for the product of two units, in either order.
std::string product(const std::string& a, const std::string& b) {
  return fmt::format("({}{}{}|{}{}{})", a, kTimes, b, b, kTimes, a);
}

/// Returns a regular expression for the quotient of two units, as a/b^n or as a times b^-n, where n is `exponent`.
std::string quotient(const std::string& a, const std::string& b, int exponent = 1) {
  return fmt::format("({}({}{}|{}{}))", a, kOver, power(b, exponent), kTimes, power(b, -exponent));
}

std::string massSquarePattern() {
  const std::string length = namesPattern(kL);
  const std::string square = fmt::format("({}|{}{}{})", power(length, 2), length, kTimes, length);
  return product(namesPattern(kM), square);
}

/// Returns a regular expression that matches units such as "J", "N m" and "in lbf".
std::string shortWorkPattern() {
  return either({namesPattern(kWork), product(namesPattern(kForce), namesPattern(kL))});
}

std::string workPattern() {
  return either({shortWorkPattern(), quotient(massSquarePattern(), namesPattern(kT), 2)});
}

/// Returns a regular expression that matches units such as "kg m^2", "lbf in s^2" and "lbf s^2 in".
std::string momentPattern() {
  const std::string square = power(namesPattern(kT), 2);
  return either({massSquarePattern(), shortWorkPattern() + kTimes + square,
                 namesPattern(kForce) + kTimes + square + kTimes + namesPattern(kL)});
}

std::string momentumPattern() {
  const std::string time = namesPattern(kT), moved = product(namesPattern(kM), namesPattern(kL));
  return either({quotient(moved, time), product(namesPattern(kForce), time)});
}

std::string angularMomentumPattern() {
  const std::string time = namesPattern(kT);
  return either({namesPattern(kAction), quotient(massSquarePattern(), time), workPattern() + kTimes + time});
}

std::string ratePattern() {
  return fmt::format("((1 *)?/ *{}|{})", namesPattern(kT), power(namesPattern(kT), -1));
}

std::string inverseActionPattern() {
  const std::string length = namesPattern(kL),
                    over = fmt::format("{}{}{}", namesPattern(kT), kOver, namesPattern(kM));
  return fmt::format("({}{}{})", over, kOver, power(length, 2));
}

}  // namespace

std::string unitPattern(Dimension dimension) {
  switch (dimension) {
    case Dimension::kAngularVelocity:
      return either({namesPattern(kSpin), quotient(namesPattern(kA), namesPattern(kT))});
    case Dimension::kMomentOfInertia:
      return momentPattern();
    case Dimension::kDensity:
      return quotient(namesPattern(kM), namesPattern(kL), 3);
    case Dimension::kVelocity:
      return either({namesPattern(kSpeed), quotient(namesPattern(kL), namesPattern(kT))});
    case Dimension::kAcceleration:
      return quotient(namesPattern(kL), namesPattern(kT), 2);
    case Dimension::kTorque:
    case Dimension::kEnergy:
      return workPattern();
    case Dimension::kMomentum:
      return momentumPattern();
    case Dimension::kAngularMomentum:
      return angularMomentumPattern();
    case Dimension::kRate:
      return ratePattern();
    case Dimension::kInverseAction:
      return inverseActionPattern();
    default:
      return namesPattern(textOf(dimension).exponents);
  }
}

}  // namespace poinsot::scene
