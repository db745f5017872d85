// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "scene/document/document.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {

/// Checks a value against the type, dimension and range of its key.
/// @param path  path of the value, which has an index where the path of the key has []
/// @param limits  limits of the user; a range can depend on one of them
/// @returns the value in SI units; nullopt if the value is invalid, which is then reported to `problems`
std::optional<Checked> check(const Key& key, std::string_view path, const Node& node, Problems& problems,
                             const Limits& limits = {});

}  // namespace poinsot::scene
