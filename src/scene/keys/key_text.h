// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/keys/keys.h"

/// What a key takes, in words.
namespace poinsot::scene {

/// "from 1 to 120 deg", "one of "light", "dark""; empty where anything of the type will do.
std::string rangeText(const Key& key);

/// What a value of the key's type is, for messages and the reference: "an angle", "three lengths".
std::string typeText(const Key& key);

/// "from 1 to 120 deg", without the words a number may be; empty where any will do.
std::string numbersText(const Key& key);

/// "one of "light", "dark"".
std::string wordsText(const Key& key);

/// How a table is opened: "[show]"; "[[body.part]]" for "body.part" and "body.part[]".
std::string tableText(std::string_view table);

/// " kg" for "kg"; empty for a plain number.
std::string unitSuffix(std::string_view unit);

}  // namespace poinsot::scene
