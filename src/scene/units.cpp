// SPDX-License-Identifier: Apache-2.0
#include "scene/units.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "core/expect.h"
#include "core/text.h"
#include "scene/unit_table.h"

namespace poinsot::scene {
namespace {

bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

void skipBlanks(std::string_view& text) {
  while (skip(text, " ")) continue;
}

bool partOfName(std::string_view text) {
  if (text.starts_with("·") || text.starts_with("²") || text.starts_with("³")) return false;
  const char c = text[0];
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || c == '%' || static_cast<unsigned char>(c) >= 0x80;
}

std::string_view takeName(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && partOfName(text.substr(length))) ++length;
  const std::string_view name = text.substr(0, length);
  text.remove_prefix(length);
  return name;
}

// Four is the largest power any sensible unit needs; the bound also keeps the sums of exponents small.
constexpr int kLargestPower = 4;
constexpr int kMostTerms = 8;

std::optional<int> takePower(std::string_view& text) {
  if (skip(text, "²")) return 2;
  if (skip(text, "³")) return 3;
  const bool bareDigit = !text.empty() && text[0] >= '2' && text[0] <= '0' + kLargestPower;  // cm3
  if (!skip(text, "^") && !bareDigit) return 1;
  int power = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (status != std::errc() || std::abs(power) > kLargestPower) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return power;
}

std::optional<Unit> unitNamed(std::string_view name) {
  for (const NamedUnit& known : kUnits)
    if (known.name == name) return known.unit;
  return std::nullopt;
}

void multiply(Unit& product, const Unit& unit, int power) {
  // Repeated products and one division: std::pow gives different last bits with and without FMA.
  double factor = 1;
  for (int i = 0; i < std::abs(power); ++i) factor *= unit.factor;
  product.factor = power < 0 ? product.factor / factor : product.factor * factor;
  for (std::size_t i = 0; i < product.exponents.size(); ++i) product.exponents[i] += power * unit.exponents[i];
}

struct ParsedUnit {
  Unit unit;
  std::string problem;
};

/// The '/' that a unit may begin with, or "1/".
bool takeDivisor(std::string_view& text) {
  std::string_view rest = text;
  if (skip(rest, "1")) skipBlanks(rest);
  if (!skip(rest, "/")) return false;
  skipBlanks(rest);
  text = rest;
  return true;
}

// [[1] /] term { (blank | * | ·) term | / term }, term = name [^n | n | ² | ³]. A '/' divides by the one term
// after it.
ParsedUnit parseUnit(std::string_view text) {
  ParsedUnit parsed;
  const std::string whole = core::printable(text);
  bool divides = takeDivisor(text);
  for (int terms = 0; terms < kMostTerms; ++terms) {
    const std::string_view name = takeName(text);
    const auto unit = unitNamed(name);
    if (!unit)
      return {{}, fmt::format("\"{}\" is not a known unit", name.empty() ? whole : core::printable(name))};
    const auto power = takePower(text);
    if (!power) return {{}, fmt::format("the power in \"{}\" is not understood", whole)};
    multiply(parsed.unit, *unit, divides ? -*power : *power);
    skipBlanks(text);
    if (text.empty()) return parsed;
    divides = skip(text, "/");
    if (!divides && !skip(text, "*")) skip(text, "·");
    skipBlanks(text);
  }
  return {{}, fmt::format("the unit \"{}\" is too long", whole)};
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// "rpm" for "RPM".
std::string inSmallLetters(std::string_view unit) {
  std::string text(unit);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// "; did you mean "rpm"?" where that would have been a unit of the dimension, else empty.
std::string hint(std::string_view unit, Dimension dimension) {
  const std::string meant = inSmallLetters(unit);
  const ParsedUnit parsed = parseUnit(meant);
  const bool known = parsed.problem.empty() && parsed.unit.exponents == textOf(dimension).exponents;
  return known ? fmt::format("; did you mean \"{}\"?", core::printable(meant)) : "";
}

std::string expected(Dimension dimension) {
  if (dimension == Dimension::kNone) return "expected a plain number";
  return fmt::format("expected {} in one of {}", textOf(dimension).name, textOf(dimension).usual);
}

Quantity refused(std::string problem) { return {std::numeric_limits<double>::quiet_NaN(), std::move(problem)}; }

}  // namespace

std::span<const Dimension> dimensions() { return kAll; }

std::string_view quantityName(Dimension dimension) { return textOf(dimension).name; }
std::string_view pluralName(Dimension dimension) { return textOf(dimension).plural; }
std::string_view siUnit(Dimension dimension) { return textOf(dimension).si; }
std::string_view usualUnits(Dimension dimension) { return textOf(dimension).usual; }

Quantity parseQuantity(std::string_view text, Dimension dimension) {
  const std::string shown = core::printable(text);
  text = trimmed(text);
  if (skip(text, "+") && text.starts_with('-')) return refused(expected(dimension) + ", got \"" + shown + "\"");
  double number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status == std::errc::invalid_argument) return refused(expected(dimension) + ", got \"" + shown + "\"");
  if (status != std::errc()) return refused(fmt::format("the number in \"{}\" is out of range", shown));
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with(','))
    return refused(fmt::format("numbers have a decimal point, not a comma, got \"{}\"", shown));
  skipBlanks(text);
  if (text.empty() && dimension == Dimension::kNone)
    return refused(fmt::format("a plain number stands without quotes, got \"{}\"", shown));
  if (text.empty())
    return refused(fmt::format("\"{}\" has no unit, such as {}; without quotes it is in {}", shown,
                               textOf(dimension).usual, siUnit(dimension)));
  const ParsedUnit parsed = parseUnit(text);
  if (!parsed.problem.empty()) return refused(parsed.problem + "; " + expected(dimension) + hint(text, dimension));
  if (parsed.unit.exponents != textOf(dimension).exponents)
    return refused(fmt::format("{}, got \"{}\"", expected(dimension), shown));
  return {number * parsed.unit.factor, ""};
}

double unitFactor(std::string_view unit, Dimension dimension) {
  if (unit.empty()) return 1;
  const ParsedUnit parsed = parseUnit(unit);
  POINSOT_EXPECT(parsed.problem.empty());
  POINSOT_EXPECT(parsed.unit.exponents == textOf(dimension).exponents);
  return parsed.unit.factor;
}

}  // namespace poinsot::scene
