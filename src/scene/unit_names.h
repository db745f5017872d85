// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/unit_table.h"

/// Names of single units, with and without a prefix: what the rows of unit_table.h stand for.
namespace poinsot::scene {

struct NamedUnit {
  std::string name;  ///< "km", "kilometres"
  Unit unit;
  std::string_view prefix;  ///< "k", "kilo", or empty
};

/// Every spelling, in the order of the table.
const std::vector<NamedUnit>& namedUnits();

/// Pieces of a text between its blanks.
std::vector<std::string_view> wordsIn(std::string_view text);

/// The prefixes that a row takes, in the order of kPrefixes.
std::vector<Prefix> prefixesOf(const UnitRow& row);

/// The unit of exactly this name; none where no unit has it.
std::optional<Unit> unitNamed(std::string_view name);

/// The name that differs from `name` by case alone: "rpm" for "Rpm", "kHz" for "KHz". None where two units have
/// such a name ("MHZ" is MHz or mHz), or where the prefix itself would become another one ("Mm" is not mm).
std::optional<std::string> recased(std::string_view name);

}  // namespace poinsot::scene
