// SPDX-License-Identifier: Apache-2.0
#include "stage/type/written_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poinsot::stage {
namespace {

using scene::QuantityUnit;

constexpr double kResolution = 250;  // smallest number of values in a range that decimals must distinguish

struct TimeUnit {
  double seconds;
  double upTo;  ///< largest number in this unit
  std::string_view tex;
};

// Units change at ten minutes (600 s), three hours (180 min), three days (72 h) and three years (1096 d). The year
// is the Julian year.
constexpr TimeUnit kTimeUnits[] = {
    {1e-6, 1e4, "\\text{µ}\\mathrm{s}"}, {1e-3, 100, "\\mathrm{ms}"}, {1, 600, "\\mathrm{s}"},
    {60, 180, "\\mathrm{min}"},          {3600, 72, "\\mathrm{h}"},   {86400, 1096, "\\mathrm{d}"}};
constexpr TimeUnit kYear{365.25 * 86400, 0, "\\mathrm{yr}"};

WrittenUnit scaled(std::string_view tex, double perSi, double largest) {
  const double size = std::abs(largest) * perSi;
  if (!(size > 0) || (size >= 1e-2 && size < 1e4)) return {perSi, 0, std::string(tex)};
  const int power = 3 * static_cast<int>(std::floor(std::log10(size) / 3));
  return {perSi * std::pow(10.0, -power), power, std::string(tex)};
}

WrittenUnit timeUnit(double largest) {
  for (const TimeUnit& unit : kTimeUnits)
    if (largest <= unit.upTo * unit.seconds) return scaled(unit.tex, 1 / unit.seconds, largest);
  return scaled(kYear.tex, 1 / kYear.seconds, largest);
}

std::string factorAndUnit(const WrittenUnit& unit) {
  if (unit.powerOfTen == 0) return unit.tex;
  const std::string factor = fmt::format("10^{{{}}}", unit.powerOfTen);
  return unit.tex.empty() ? factor : fmt::format("{}\\,{}", factor, unit.tex);
}

/// Returns a unit's name for use inside \mathrm, which supports only ASCII letters.
std::string nameInFormula(std::string name) {
  if (name == "%") return "\\%";
  constexpr std::pair<std::string_view, std::string_view> kLetters[] = {{"µ", "}\\text{µ}\\mathrm{"},
                                                                        {"μ", "}\\text{µ}\\mathrm{"},
                                                                        {"Å", "}\\text{Å}\\mathrm{"},
                                                                        {"Å", "}\\text{Å}\\mathrm{"}};
  for (const auto& [letter, tex] : kLetters)
    if (const auto at = name.find(letter); at != std::string::npos) return name.replace(at, letter.size(), tex);
  return name;
}

std::string powerInFormula(int power) {
  if (power == 1) return "";
  return power < 0 ? fmt::format("^{{{}}}", power) : fmt::format("^{}", power);
}

bool isProduct(const WrittenUnit& unit) {
  const bool factor = unit.powerOfTen != 0 && !unit.tex.empty();
  return factor || unit.tex.find_first_of("/^") != std::string_view::npos;
}

}  // namespace

WrittenUnit writtenUnit(QuantityUnit unit, double largest) {
  switch (unit) {
    case QuantityUnit::kSecond:
      return timeUnit(largest);
    case QuantityUnit::kMetre:
      return scaled("\\mathrm{m}", 1, largest);
    case QuantityUnit::kMetrePerSecond:
      return scaled("\\mathrm{m/s}", 1, largest);
    case QuantityUnit::kRadianPerSecond:
      return scaled("\\mathrm{rad/s}", 1, largest);
    case QuantityUnit::kMomentum:
      return scaled("\\mathrm{kg\\,m/s}", 1, largest);
    case QuantityUnit::kAction:
      return scaled("\\mathrm{kg\\,m^2/s}", 1, largest);
    case QuantityUnit::kJoule:
      return scaled("\\mathrm{J}", 1, largest);
    case QuantityUnit::kAngle:
      return scaled("\\degree", 180 / std::numbers::pi, largest);
    case QuantityUnit::kBare:
      break;
  }
  return scaled("", 1, largest);
}

WrittenUnit writtenUnit(QuantityUnit unit, double largest, const std::string& asked) {
  if (asked.empty()) return writtenUnit(unit, largest);
  return {1 / scene::unitFactor(asked, scene::dimensionOf(unit)), 0, unitInFormula(asked)};
}

std::string unitInFormula(const std::string& unit) {
  if (unit.empty()) return "";
  if (unit == "deg" || unit == "°") return "\\degree";
  std::string tex;
  for (const scene::UnitTerm& term : scene::unitTerms(unit)) {
    if (!tex.empty() || term.divides) tex += term.divides ? (tex.empty() ? "1/" : "/") : "\\,";
    tex += nameInFormula(term.name) + powerInFormula(term.power);
  }
  return "\\mathrm{" + tex + "}";
}

std::string axisLabel(std::string_view tex, const WrittenUnit& unit) {
  const std::string divisor = factorAndUnit(unit);
  if (divisor.empty()) return fmt::format("${}$", tex);
  return isProduct(unit) ? fmt::format("${}\\,/\\,({})$", tex, divisor)
                         : fmt::format("${}\\,/\\,{}$", tex, divisor);
}

std::string unitSuffix(const WrittenUnit& unit) {
  const std::string text = factorAndUnit(unit);
  if (text.empty()) return "";
  const char* gap =
      unit.powerOfTen == 0 && unit.tex == "\\degree" ? "" : "\\,";  // 30°, but 30 s (ISO 80000-1, 7.1.4)
  return fmt::format("${}{}{}$", gap, unit.powerOfTen == 0 ? "" : "\\times\\,", text);
}

std::string numberTex(std::string_view digits, scene::DecimalSign sign) {
  return "$" + digitsInFormula(digits, sign) + "$";
}

std::string digitsInFormula(std::string_view digits, scene::DecimalSign sign) {
  std::string tex;
  for (const char c : digits)
    if (c == '.')
      tex += sign == scene::DecimalSign::kComma ? "{,}" : ".";
    else
      tex += c;
  return tex;
}

int decimalsThatResolve(double length) {
  return std::max(0, static_cast<int>(std::ceil(-std::log10(length / kResolution))));
}

std::string fixedDigits(double x, int decimals) {
  if (!std::isfinite(x)) return "--";
  std::string digits = fmt::format("{:.{}f}", x, decimals);
  const bool zero = digits.find_first_of("123456789") == std::string::npos;
  return zero && digits[0] == '-' ? digits.substr(1) : digits;
}

}  // namespace poinsot::stage
