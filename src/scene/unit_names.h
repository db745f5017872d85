// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/unit_table.h"

/// Names of single units, with and without a prefix, expanded from the rows of unit_table.h.
namespace poinsot::scene {

struct NamedUnit {
  std::string name;  ///< "km", "kilometres"
  Unit unit;
  std::string_view prefix;  ///< "k", "kilo", or empty
};

/// Returns every spelling of every unit, in the order of the table.
const std::vector<NamedUnit>& namedUnits();

std::vector<std::string_view> wordsIn(std::string_view text);

/// Returns the prefixes that a row accepts, in the order of kPrefixes.
std::vector<Prefix> prefixesOf(const UnitRow& row);

std::optional<Unit> unitNamed(std::string_view name);

/// Returns the unit name that differs from `name` only by case: "rpm" for "Rpm", "kHz" for "KHz". Returns nullopt
/// if different units match ("MHZ" is MHz or mHz), or if the prefix would become another one ("Mm" is not mm).
std::optional<std::string> recased(std::string_view name);

}  // namespace poinsot::scene
