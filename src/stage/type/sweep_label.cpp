// SPDX-License-Identifier: Apache-2.0
#include "stage/type/sweep_label.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/error.h"
#include "core/number.h"
#include "scene/motion/film_clock.h"
#include "scene/units.h"
#include "stage/picture_motion.h"
#include "stage/type/written_number.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

struct Symbol {
  std::string_view key;
  std::string_view tex;  ///< symbol without an index
  bool inAxes = false;   ///< components along axes of the body; otherwise along axes of space
};

constexpr std::array kSymbols{Symbol{"motion.omega_body", "\\omega", true},
                              Symbol{"motion.omega_space", "\\omega"},
                              Symbol{"motion.L_body", "L", true},
                              Symbol{"motion.L_space", "L"},
                              Symbol{"motion.spin", "\\omega"},
                              Symbol{"motion.energy", "T"},
                              Symbol{"motion.L", "L"},
                              Symbol{"body.principal_moments", "I", true},
                              Symbol{"body.mass", "m"},
                              Symbol{"body.catalogue", ""},
                              Symbol{"time.start", "t_0"},
                              Symbol{scene::kInstantKey, "t"}};

/// Returns the last words of a key's path: "plane opacity" for "show.plane.opacity". Outside `show`, returns only
/// the last part of the path.
std::string wordsOf(std::string_view path) {
  auto from = path.rfind('.');
  if (path.starts_with("show.") && from != std::string_view::npos && from > 4) from = path.rfind('.', from - 1);
  std::string words(path.substr(from == std::string_view::npos ? 0 : from + 1));
  std::ranges::replace(words, '_', ' ');
  std::ranges::replace(words, '.', ' ');
  return words;
}

/// Returns the index of a component: 1, 2 or 3 for principal axes, otherwise x, y or z.
std::string indexOf(int element, bool numbered) {
  constexpr std::string_view kLetters = "xyz";
  if (numbered || element > 2) return fmt::format("{}", element + 1);
  return std::string(1, kLetters[static_cast<std::size_t>(element)]);
}

/// Converts a number to TeX inside a formula: "1.5e-07" becomes 1.5\times 10^{-7}.
std::string numberInFormula(const std::string& typed, scene::DecimalSign sign) {
  const auto e = typed.find_first_of("eE");
  std::string digits = numberTex(std::string_view(typed).substr(0, e), sign);
  digits = digits.substr(1, digits.size() - 2);
  if (e == std::string::npos) return digits;
  return fmt::format("{}\\times 10^{{{}}}", digits, std::stoi(typed.substr(e + 1)));
}

std::string gapAndUnit(const std::string& unit) {
  const std::string tex = unitInFormula(unit);
  return tex.empty() || tex == "\\degree" ? tex : "\\," + tex;
}

void expectTex(const std::string& name) {
  try {
    text::setTex(name);
  } catch (const core::Error& error) {
    throw core::usageError("--label: " + error.message());
  }
}

std::string nameOf(const scene::SweepAxis& axis, std::size_t number, const std::vector<std::string>& names,
                   const scene::Scene& scene) {
  if (number >= names.size()) return sweptName(axis, scene);
  expectTex(names[number]);
  return names[number];
}

}  // namespace

namespace {

/// Adds the labels of a value that is a word, such as "spin axis: smallest"; the word alone if the key has no
/// name.
void addWord(SweepLabels& labels, const std::string& word) {
  std::string tex;
  for (const char c : word) tex += c == '_' ? std::string("\\_") : std::string(1, c);
  labels.values.push_back(tex);
  labels.whole.push_back(labels.name.empty() ? tex : labels.name + ": " + tex);
}

/// Adds the label of a number. @param tex  number with its unit, as TeX in a formula
void addNumber(SweepLabels& labels, const std::string& tex) {
  labels.values.push_back("$" + tex + "$");
  // If the name is a formula, name and value become one formula, so that TeX spaces them as a formula.
  const bool formula = labels.name.starts_with('$') && labels.name.ends_with('$');
  labels.whole.push_back(formula ? labels.name.substr(0, labels.name.size() - 1) + " = " + tex + "$"
                                 : labels.name + " $= " + tex + "$");
}

/// Returns the smallest number of decimals whose rounding moves no number by more than `tolerance`; at most `most`
/// decimals.
int decimalsWithin(const std::vector<double>& numbers, double tolerance, int most) {
  int decimals = 0;
  const auto moves = [&](double x) {
    const double scale = std::pow(10.0, decimals);
    return std::abs(std::round(x * scale) / scale - x) > tolerance;
  };
  while (decimals < most && std::ranges::any_of(numbers, moves)) ++decimals;
  return decimals;
}

/// Returns as many decimals as the numbers have, if they are few. Otherwise, the rounding error is at most a
/// hundredth of the smallest difference, so that equal steps look equal.
int labelDecimals(const std::vector<double>& numbers) {
  constexpr int kFew = 4, kMost = 12;
  double largest = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    largest = std::max(largest, std::abs(numbers[i]));
    const double step = i > 0 ? std::abs(numbers[i] - numbers[i - 1]) : 0;
    if (step > 0) least = std::min(least, step);
  }
  const double rounding = 1e-9 * largest;
  const int exact = decimalsWithin(numbers, rounding, kFew + 1);
  return exact <= kFew ? exact : decimalsWithin(numbers, std::max(1e-2 * least, rounding), kMost);
}

/// Adds the labels of instants: the times of the motion, in the unit of a read-out of t.
void addInstants(SweepLabels& labels, const scene::SweepAxis& axis, const scene::Scene& scene) {
  const std::vector<double> times_s = instants_s(axis, scene);
  double largest_s = 0;
  for (const double t_s : times_s) largest_s = std::max(largest_s, std::abs(t_s));
  const WrittenUnit unit = writtenUnit(scene::QuantityUnit::kSecond, largest_s);
  std::vector<double> numbers;
  for (const double t_s : times_s) numbers.push_back(unit.written(t_s));
  const int decimals = labelDecimals(numbers);
  const std::string suffix = unitSuffix(unit);
  for (const double number : numbers)
    addNumber(labels, numberInFormula(fixedDigits(number, decimals), scene.style.decimalSign) +
                          suffix.substr(1, suffix.size() - 2));
}

}  // namespace

std::vector<double> instants_s(const scene::SweepAxis& axis, const scene::Scene& scene) {
  const double unit_s = axis.unit.empty() ? 1 : scene::unitFactor(axis.unit, scene::Dimension::kTime);
  const scene::FilmClock clock = filmClock(scene);
  std::vector<double> times_s;
  for (const scene::SweepValue& value : axis.values)
    times_s.push_back(
        clock.motionTime_s(std::min(unit_s * core::parseNumber(value.number).value(), scene.time.duration_s)));
  return times_s;
}

std::string sweptName(const scene::SweepAxis& axis, const scene::Scene& scene) {
  const auto symbol = std::ranges::find(kSymbols, axis.key, &Symbol::key);
  if (symbol == kSymbols.end()) {
    const std::string words = wordsOf(axis.key);
    return axis.element ? fmt::format("$\\text{{{}}}_{}$", words, *axis.element + 1) : words;
  }
  if (symbol->tex.empty()) return "";
  if (!axis.element) return fmt::format("${}$", symbol->tex);
  const bool numbered = symbol->inAxes && scene.body.axes.aligned();
  return fmt::format("${}_{}$", symbol->tex, indexOf(*axis.element, numbered));
}

std::vector<SweepLabels> sweepLabels(const std::vector<scene::SweepAxis>& axes,
                                     const std::vector<std::string>& names, const scene::Scene& scene) {
  std::vector<SweepLabels> all;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    SweepLabels& labels = all.emplace_back();
    labels.name = nameOf(axes[i], i, names, scene);
    if (axes[i].variesInstant()) {
      addInstants(labels, axes[i], scene);
      continue;
    }
    for (const scene::SweepValue& value : axes[i].values) {
      if (axes[i].isWords) {
        addWord(labels, value.number);
        continue;
      }
      addNumber(labels, numberInFormula(value.number, scene.style.decimalSign) + gapAndUnit(axes[i].unit));
    }
  }
  return all;
}

}  // namespace poinsot::stage
