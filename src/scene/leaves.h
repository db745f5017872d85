// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "scene/document.h"
#include "scene/keys.h"

namespace poinsot::scene {

/// The values of known keys, by path, each with the place it came from.
using Leaves = std::map<std::string, Node, std::less<>>;

/// Adds the values of a whole document; a later call replaces what an earlier one gave. Keys that are not in the
/// table become problems, with the nearest name that is. `show.plane = false` is read as show.plane.visible.
void addLeaves(const Node& document, Leaves& leaves, Problems& problems);

/// Adds the value of one path.
void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems);

}  // namespace poinsot::scene
