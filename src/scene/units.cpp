// SPDX-License-Identifier: Apache-2.0
#include "scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/expect.h"
#include "core/text.h"
#include "scene/unit_names.h"

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

// Superscript digits; the index is the digit. A superscript minus may precede a digit.
constexpr std::string_view kSuperscripts[] = {"⁰", "¹", "²", "³", "⁴"};
constexpr std::string_view kSuperscriptMinus = "⁻";

// Multiplication signs between two units. A hyphen before a digit is not a multiplication sign, but the sign of a
// power. The raised dot exists as two Unicode characters.
constexpr std::string_view kTimesSigns[] = {"*", "·", "⋅", "×", ".", "-"};

bool startsWithOneOf(std::string_view text, std::span<const std::string_view> signs) {
  return std::ranges::any_of(signs, [&](std::string_view sign) { return text.starts_with(sign); });
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool partOfName(std::string_view text) {
  if (startsWithOneOf(text, kSuperscripts) || startsWithOneOf(text, kTimesSigns)) return false;
  if (text.starts_with(kSuperscriptMinus)) return false;
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

// Largest power of a unit. No sensible unit needs more, and the sums of exponents stay small.
constexpr int kLargestPower = 4;
constexpr int kMostTerms = 8;

std::optional<int> takeSuperscript(std::string_view& text) {
  std::string_view rest = text;
  const int sign = skip(rest, kSuperscriptMinus) ? -1 : 1;
  for (int power = 0; power <= kLargestPower; ++power)
    if (skip(rest, kSuperscripts[power])) {
      text = rest;
      return sign * power;
    }
  return std::nullopt;
}

/// Returns whether a power follows that has no ^ or **, as in cm3 and s-1.
bool hasBarePower(std::string_view text) {
  if (text.size() > 1 && text[0] == '-') return isDigit(text[1]);
  return !text.empty() && text[0] >= '2' && text[0] <= '0' + kLargestPower;
}

std::optional<int> takePower(std::string_view& text) {
  if (const auto power = takeSuperscript(text)) return power;
  if (!skip(text, "**") && !skip(text, "^") && !hasBarePower(text)) return 1;
  int power = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (status != std::errc() || std::abs(power) > kLargestPower) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return power;
}

void skipTimes(std::string_view& text) {
  for (const std::string_view sign : kTimesSigns)
    if (skip(text, sign)) return;
}

struct ParsedUnit {
  std::vector<UnitTerm> terms;
  std::string problem;
};

/// Removes a '/' or "1/" from the start of a unit. Returns whether there was one.
bool takeDivisor(std::string_view& text) {
  std::string_view rest = text;
  if (skip(rest, "1")) skipBlanks(rest);
  if (!skip(rest, "/")) return false;
  skipBlanks(rest);
  text = rest;
  return true;
}

// Parses a unit with this grammar:
//   [[1] /] term { (blank | times) term | / term }
//   term = name [power]
//   times = one of kTimesSigns
//   power = a superscript, or [^ | **] and a number
// A '/' applies only to the term after it.
ParsedUnit parseUnit(std::string_view text) {
  ParsedUnit parsed;
  const std::string whole = core::printable(text);
  bool divides = takeDivisor(text);
  for (int terms = 0; terms < kMostTerms; ++terms) {
    const std::string_view name = takeName(text);
    if (!unitNamed(name))
      return {{}, fmt::format("\"{}\" is not a known unit", name.empty() ? whole : core::printable(name))};
    const auto power = takePower(text);
    if (!power) return {{}, fmt::format("\"{}\" has an invalid power", whole)};
    parsed.terms.push_back({std::string(name), *power, divides});
    skipBlanks(text);
    if (text.empty()) return parsed;
    divides = skip(text, "/");
    if (!divides) skipTimes(text);
    skipBlanks(text);
  }
  return {{}, fmt::format("the unit \"{}\" is too long", whole)};
}

void multiply(Unit& product, const Unit& unit, int power) {
  // std::pow is not used, because its last bits depend on FMA.
  double factor = 1;
  for (int i = 0; i < std::abs(power); ++i) factor *= unit.factor;
  product.factor = power < 0 ? product.factor / factor : product.factor * factor;
  for (std::size_t i = 0; i < product.exponents.size(); ++i) product.exponents[i] += power * unit.exponents[i];
}

Unit productOf(const std::vector<UnitTerm>& terms) {
  Unit product;
  for (const UnitTerm& term : terms)
    multiply(product, *unitNamed(term.name), term.divides ? -term.power : term.power);
  return product;
}

bool isUnitOf(const ParsedUnit& parsed, Dimension dimension) {
  return parsed.problem.empty() && productOf(parsed.terms).exponents == textOf(dimension).exponents;
}

template <class F>
std::string renamed(std::string_view unit, F other) {
  std::string text;
  while (!unit.empty()) {
    const std::string_view name = takeName(unit);
    text += name.empty() ? std::string(1, unit[0]) : other(std::string(name));
    if (name.empty()) unit.remove_prefix(1);
  }
  return text;
}

std::string knownName(const std::string& name) { return unitNamed(name) ? name : recased(name).value_or(name); }

/// Returns the unit of force for a unit of mass, such as "lbf" for "lb". Users who write lb ft mean lbf ft.
std::string forceName(const std::string& name) {
  constexpr std::pair<std::string_view, std::string_view> kForces[] = {
      {"lb", "lbf"}, {"lbs", "lbf"}, {"oz", "ozf"}, {"kg", "kgf"}, {"g", "gf"}};
  const auto* found = std::ranges::find(kForces, name, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kForces) ? name : std::string(found->second);
}

/// Returns a suggestion such as "; did you mean "rpm"?" if a corrected unit has the dimension; otherwise "".
std::string hint(std::string_view unit, Dimension dimension) {
  constexpr std::size_t kLongest = 64;  // characters; each name in the text costs a search of the table
  if (unit.size() > kLongest) return "";
  for (const std::string& meant : {renamed(unit, knownName), renamed(unit, forceName)})
    if (isUnitOf(parseUnit(meant), dimension))
      return fmt::format("; did you mean \"{}\"?", core::printable(meant));
  return "";
}

std::string expected(Dimension dimension) {
  if (dimension == Dimension::kNone) return "expected a plain number";
  return fmt::format("expected {} in one of {}", textOf(dimension).name, someUnits(dimension));
}

Quantity refused(std::string problem) { return {std::numeric_limits<double>::quiet_NaN(), std::move(problem)}; }

}  // namespace

std::span<const Dimension> dimensions() { return kAll; }

std::string_view quantityName(Dimension dimension) { return textOf(dimension).name; }
std::string_view pluralName(Dimension dimension) { return textOf(dimension).plural; }
std::string_view siUnit(Dimension dimension) { return textOf(dimension).si; }
std::string_view usualUnits(Dimension dimension) { return textOf(dimension).usual; }

std::string someUnits(Dimension dimension) {
  return fmt::format("{} (poinsot explain units lists all)", usualUnits(dimension));
}

Quantity parseQuantity(std::string_view text, Dimension dimension) {
  const std::string shown = core::printable(text);
  text = core::trimmed(text);
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
    return refused(fmt::format("write a plain number without quotes, got \"{}\"", shown));
  if (text.empty())
    return refused(fmt::format("\"{}\" has no unit, such as {}; without quotes it is in {}", shown,
                               someUnits(dimension), siUnit(dimension)));
  const ParsedUnit parsed = parseUnit(text);
  if (!parsed.problem.empty()) return refused(parsed.problem + "; " + expected(dimension) + hint(text, dimension));
  if (!isUnitOf(parsed, dimension))
    return refused(fmt::format("{}, got \"{}\"{}", expected(dimension), shown, hint(text, dimension)));
  return {number * productOf(parsed.terms).factor, ""};
}

double unitFactor(std::string_view unit, Dimension dimension) {
  if (unit.empty()) return 1;
  const ParsedUnit parsed = parseUnit(unit);
  POINSOT_EXPECT(isUnitOf(parsed, dimension));
  return productOf(parsed.terms).factor;
}

std::vector<UnitTerm> unitTerms(std::string_view unit) { return parseUnit(core::trimmed(unit)).terms; }

}  // namespace poinsot::scene
