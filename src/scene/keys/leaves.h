// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/document/document.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"

namespace poinsot::scene {

/// Values that a scene gives, by their paths, such as "body.part[0].mass".
struct Leaves {
  Limits limits{};
  std::map<std::string, Node, std::less<>> values{};         ///< values of known keys, with their positions
  std::map<std::string, Place, std::less<>> tables{};        ///< position of each table
  std::map<std::string, std::size_t, std::less<>> counts{};  ///< number of elements of each array of tables
  /// Unknown or malformed names, by the path of their table. For each table, only the first names are stored.
  std::map<std::string, std::vector<std::string>, std::less<>> unknown{};
  std::set<std::string, std::less<>>
      meant{};  ///< keys for which unknown names stand, such as motion.omega_body for w
  std::map<std::string, std::string, std::less<>> examples{};  ///< values of these keys in messages, as TOML
  /// Tables of this program by the names of tables in other programs, such as motion.torque for torque.
  std::map<std::string, std::string, std::less<>> aliases{};
  std::set<std::string, std::less<>> broken{};  ///< tables with broken lines, as in PartialDocument

  std::size_t count(std::string_view array) const {
    const auto found = counts.find(array);
    return found == counts.end() ? 0 : found->second;
  }
};

/// Adds the values of a document. They replace values with the same path. An unknown key becomes a problem that
/// suggests the most similar name. `show.plane = false` becomes the value of show.plane.visible.
void addLeaves(const Node& document, Leaves& leaves, Problems& problems);

/// Adds the value with this path. If the path contains an index, the element must already exist.
void addLeaf(const std::string& path, const Place& keyPlace, const Node& value, Leaves& leaves,
             Problems& problems);

}  // namespace poinsot::scene
