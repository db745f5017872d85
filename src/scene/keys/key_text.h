// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/keys/keys.h"

namespace poinsot::scene {

/// Describes the values that a key allows, such as "from 1 to 120 deg" or "one of "light", "dark"". Empty if the
/// key allows all values of its type.
std::string rangeText(const Key& key);

/// Describes the type of a key's value for messages and the reference, such as "an angle" or "three lengths".
std::string typeText(const Key& key);

/// Describes the numbers that a key allows, such as "from 1 to 120 deg". Leaves out words that the key also
/// allows. Empty if the key allows any number.
std::string numbersText(const Key& key);

std::string wordsText(const Key& key);

/// Returns the header of a table as TOML: "[show]" for "show", "[[body.part]]" for "body.part" and "body.part[]".
std::string tableText(std::string_view table);

/// Returns the unit with a leading blank, such as " kg"; empty for a plain number.
std::string unitSuffix(std::string_view unit);

}  // namespace poinsot::scene
