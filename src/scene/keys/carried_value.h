// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/document.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"

namespace poinsot::scene {

constexpr double kUsualFilm_s = 20;  // length of a film that shows a motion of hours or days

/// Line "name = value" of a table, in TOML.
struct KeyLine {
  std::string name, value;
  std::string table{};  ///< path of the table, if it is not the table of the key for which the lines stand
};

/// Returns a value as TOML in the first form that a key accepts, such as "[0, 0, 3]" for the number 3 and a key
/// that takes a vector. Empty if the key accepts no form of the value.
/// @param unit  unit of a bare number; "" for the SI unit
std::optional<std::string> carriedValue(const Key& key, const Node& given, const Limits& limits,
                                        std::string_view unit = "");

/// Returns the lines by which a key takes over the values of foreign names. Empty if the key does not accept them.
/// @param values  the value of each name of the row; null for a missing name. For a single name, one value.
std::vector<KeyLine> carriedLines(const ForeignNames& row, const Key& key, const std::vector<const Node*>& values,
                                  const Limits& limits);

/// Returns the values of the keys of motion.euler, or of its rates, for three values in their order. Other orders
/// are those of "321", "zyx" and "xyz", whose key is motion.roll_pitch_yaw.
/// @param key  motion.euler.precession or motion.euler_rates.precession
std::vector<KeyLine> eulerLines(const Key& key, const Node& three, const Limits& limits);

/// Returns a time in seconds; empty for other values.
std::optional<double> secondsIn(const Node* given);

/// Returns the seconds since 1970 for a text such as "2014-08-06T12:00:00"; empty for other texts.
std::optional<double> dateIn(const Node* given);

/// Returns the unit at the end of a name, such as "kg/m3" for "density_kg_m3" and a key that takes a density;
/// empty if the name does not end with a unit for this key.
/// @param suffix  end of the name, such as "kg_m3"
std::string unitInName(std::string_view suffix, Dimension dimension);

}  // namespace poinsot::scene
