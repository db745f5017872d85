// SPDX-License-Identifier: Apache-2.0
#include "stage/type/sweep_label.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.h"
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
                              Symbol{"time.start", "t_0"}};

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

}  // namespace

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
    for (const scene::SweepValue& value : axes[i].values) {
      if (axes[i].isWords) {
        addWord(labels, value.number);
        continue;
      }
      const std::string tex = numberInFormula(value.number, scene.style.decimalSign) + gapAndUnit(axes[i].unit);
      labels.values.push_back("$" + tex + "$");
      // If the name is a formula, name and value become one formula, so that TeX spaces them as a formula.
      const bool formula = labels.name.starts_with('$') && labels.name.ends_with('$');
      labels.whole.push_back(formula ? labels.name.substr(0, labels.name.size() - 1) + " = " + tex + "$"
                                     : labels.name + " $= " + tex + "$");
    }
  }
  return all;
}

}  // namespace poinsot::stage
