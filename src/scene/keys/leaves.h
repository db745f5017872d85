// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/document/document.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"

namespace poinsot::scene {

/// Values that a scene gives, by path ("body.part[0].mass").
struct Leaves {
  Limits limits{};
  std::map<std::string, Node, std::less<>> values{};         ///< values of known keys, each with its place
  std::map<std::string, Place, std::less<>> tables{};        ///< place at which each table was opened
  std::map<std::string, std::size_t, std::less<>> counts{};  ///< number of tables in each array of tables
  /// Unknown or malformed names, by the table in which they are given; only the first of many.
  std::map<std::string, std::vector<std::string>, std::less<>> unknown{};

  std::size_t count(std::string_view array) const {
    const auto found = counts.find(array);
    return found == counts.end() ? 0 : found->second;
  }
};

/// Adds the values of a whole document, replacing those of earlier calls. Unknown keys become problems that
/// suggest the nearest known name. `show.plane = false` is read as show.plane.visible.
void addLeaves(const Node& document, Leaves& leaves, Problems& problems);

/// Adds the value of one path. An element of an array of tables must already exist.
void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems);

}  // namespace poinsot::scene
