// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/text.h"
#include "scene/unit_names.h"

namespace poinsot::scene {
namespace {

/// Returns the SI unit with these exponents, such as "m". Empty for a plain number.
std::string_view siOf(const Exponents& exponents) {
  // Searches backwards. Torque and energy have the same exponents, and J of the energy is preferred to N·m.
  const auto found =
      std::find_if(std::rbegin(kDimensions), std::rend(kDimensions),
                   [&](const DimensionText& dimension) { return dimension.exponents == exponents; });
  return found == std::rend(kDimensions) ? "" : found->si;
}

std::string valueText(const Unit& unit) {
  const std::string_view si = siOf(unit.exponents);
  return fmt::format("{:.15g}{}{}", unit.factor, si.empty() ? "" : " ", si);
}

UnitText textOf(const UnitRow& row) {
  const auto symbols = wordsIn(row.symbols);
  std::vector<std::string_view> also(symbols.begin() + 1, symbols.end());
  std::ranges::copy(wordsIn(row.nouns), std::back_inserter(also));
  std::vector<std::string> prefixed;
  for (const Prefix& prefix : prefixesOf(row))
    prefixed.push_back(fmt::format("{}{}", wordsIn(prefix.symbols).front(), symbols.front()));
  return {std::string(symbols.front()), valueText(row.unit), core::joined(prefixed, ", "),
          core::joined(also, ", ")};
}

}  // namespace

std::string_view unitRules() {
  return "Between two units, a blank, `*`, `·`, `×`, a point or a hyphen means multiplication: `kg m^2`, "
         "`kg*m^2`, `kg.m^2`, `kg-m^2`. A `/` divides by the next unit only. A power is `^2`, `**2`, `2` or `²`, "
         "and a negative one is `s^-1`, `s-1` or `s⁻¹`. Names are case-sensitive: `Mg` is a million grams, `mg` "
         "is a thousandth of a gram. A noun may have a plural s and a prefix in full: `millimetres`. `lb` is a "
         "mass, `lbf` is a force.";
}

std::vector<UnitText> unitTexts() {
  std::vector<UnitText> texts;
  for (const UnitRow& row : kUnits) texts.push_back(textOf(row));
  return texts;
}

std::string unitValue(std::string_view name) {
  const auto unit = unitNamed(name);
  return unit ? valueText(*unit) : "";
}

}  // namespace poinsot::scene
