// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/document/document.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"

namespace poinsot::scene {

/// What a scene gives, by path ("body.part[0].mass").
struct Leaves {
  Limits limits{};                                           ///< by which it is bounded
  std::map<std::string, Node, std::less<>> values{};         ///< of known keys, each with the place it came from
  std::map<std::string, Place, std::less<>> tables{};        ///< where each table was opened
  std::map<std::string, std::size_t, std::less<>> counts{};  ///< of the tables in each array of them
  /// By table, names given in it that are no keys, or not in the form of one; the first of many.
  std::map<std::string, std::vector<std::string>, std::less<>> unknown{};

  /// How many tables an array of them has.
  std::size_t count(std::string_view array) const {
    const auto found = counts.find(array);
    return found == counts.end() ? 0 : found->second;
  }
};

/// Adds the values of a whole document; a later call replaces what an earlier one gave. Keys that are not in the
/// table become problems, with the nearest name that is. `show.plane = false` is read as show.plane.visible.
void addLeaves(const Node& document, Leaves& leaves, Problems& problems);

/// Adds the value of one path. An element of an array of tables must exist.
void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems);

}  // namespace poinsot::scene
