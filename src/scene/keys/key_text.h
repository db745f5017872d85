// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/keys/keys.h"

namespace poinsot::scene {

/// Returns "from 1 to 120 deg" or "one of "light", "dark""; empty if any value of the type is allowed.
std::string rangeText(const Key& key);

/// Describes the type of a key's value for messages and the reference: "an angle", "three lengths".
std::string typeText(const Key& key);

/// Returns "from 1 to 120 deg", without words that may replace the number; empty if any number is allowed.
std::string numbersText(const Key& key);

std::string wordsText(const Key& key);

/// Returns the header of a table: "[show]"; "[[body.part]]" for "body.part" and "body.part[]".
std::string tableText(std::string_view table);

/// Returns " kg" for "kg"; empty for a plain number.
std::string unitSuffix(std::string_view unit);

}  // namespace poinsot::scene
