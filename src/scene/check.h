// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/document.h"
#include "scene/keys.h"

namespace poinsot::scene {

/// The value in SI if it has the key's type, dimension and range; otherwise empty, and `problems` says why, at the
/// value (at the element where that is one of several).
std::optional<Checked> check(const Key& key, const Node& node, Problems& problems);

/// "from 1 to 120 deg", "one of "light", "dark""; empty where anything of the type will do.
std::string rangeText(const Key& key);

/// What a value of the key's type is, for messages and the reference: "an angle", "three lengths".
std::string typeText(const Key& key);

}  // namespace poinsot::scene
