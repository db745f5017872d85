// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/unit_table.h"

/// Names of single units, with and without a prefix, such as "km". The names are generated from unit_table.h.
namespace poinsot::scene {

struct NamedUnit {
  std::string name;  ///< name such as "km" or "kilometres"
  Unit unit;
  std::string_view prefix;  ///< prefix in the name, such as "k" or "kilo"; may be empty
};

/// Returns all spellings of all units, in the order of the table.
const std::vector<NamedUnit>& namedUnits();

std::vector<std::string_view> wordsIn(std::string_view text);

/// Returns the prefixes that a unit can have, in the order of kPrefixes.
std::vector<Prefix> prefixesOf(const UnitRow& row);

std::optional<Unit> unitNamed(std::string_view name);

/// Returns the name of the unit that differs from `name` only by upper and lower case, such as "rpm" for "Rpm" or
/// "kHz" for "KHz". Returns nullopt if several units match ("MHZ" is MHz or mHz), or if the meaning of the prefix
/// would change ("Mm" is not mm).
std::optional<std::string> recased(std::string_view name);

}  // namespace poinsot::scene
