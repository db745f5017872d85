// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "scene/document/document.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {

/// Checks a value against the type, dimension and range of its key.
/// @param path  path of the value: the key's, with an index for each []
/// @param limits  supplies the upper end of a range that depends on a limit
/// @returns the value in SI units; nullopt if it is invalid, with a problem at the value or at its wrong element
std::optional<Checked> check(const Key& key, std::string_view path, const Node& node, Problems& problems,
                             const Limits& limits = {});

}  // namespace poinsot::scene
