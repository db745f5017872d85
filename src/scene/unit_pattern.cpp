// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <string>

#include "scene/unit_table.h"

namespace poinsot::scene {
namespace {

/// "(m|km|cm)": the named units with these exponents.
std::string namesPattern(const Exponents& exponents) {
  std::string names;
  for (const NamedUnit& known : kUnits)
    if (known.unit.exponents == exponents) names += (names.empty() ? "" : "|") + std::string(known.name);
  return "(" + names + ")";
}

constexpr const char* kTimes = R"(( +| *(\*|·) *))";

constexpr const char* kOver = "( */ *)";

/// A unit to a power: "(m|cm)(\^?2|²)".
std::string power(const std::string& names, int exponent) {
  if (exponent == 1) return names;
  const std::string superscript = exponent == 2 ? "|²" : exponent == 3 ? "|³" : "";
  return fmt::format(R"({}(\^{}{}{}))", names, exponent > 0 ? "?" : "", exponent, superscript);
}

/// Both in either order.
std::string product(const std::string& a, const std::string& b) {
  return fmt::format("({}{}{}|{}{}{})", a, kTimes, b, b, kTimes, a);
}

std::string either(std::initializer_list<std::string> patterns) {
  return fmt::format("({})", fmt::join(patterns, "|"));
}

/// a/b or a times b to the power -1 (for b squared: -2).
std::string quotient(const std::string& a, const std::string& b, int exponent = 1) {
  return fmt::format("({}({}{}|{}{}))", a, kOver, power(b, exponent), kTimes, power(b, -exponent));
}

std::string momentPattern() {
  const std::string length = namesPattern(kL);
  const std::string square = fmt::format("({}|{}{}{})", power(length, 2), length, kTimes, length);
  return product(namesPattern(kM), square);
}

std::string workPattern() {
  return either({namesPattern(kWork), product(namesPattern(kForce), namesPattern(kL)),
                 quotient(momentPattern(), namesPattern(kT), 2)});
}

std::string momentumPattern() {
  const std::string time = namesPattern(kT);
  return either({quotient(momentPattern(), time), workPattern() + kTimes + time});
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
      return quotient(namesPattern(kL), namesPattern(kT));
    case Dimension::kAcceleration:
      return quotient(namesPattern(kL), namesPattern(kT), 2);
    case Dimension::kTorque:
    case Dimension::kEnergy:
      return workPattern();
    case Dimension::kAngularMomentum:
      return momentumPattern();
    case Dimension::kRate:
      return ratePattern();
    case Dimension::kInverseAction:
      return inverseActionPattern();
    default:
      return namesPattern(textOf(dimension).exponents);
  }
}

}  // namespace poinsot::scene
