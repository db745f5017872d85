// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Name in a document that is not a key, a table or an array of tables, or a table whose value is not a table.
struct UnknownName {
  std::string path;
  Place place;
  const Node* value = nullptr;
  bool isTable = false;  ///< whether this is the name of a table, in place of which the value stands
};

/// Returns the thing in [show] for a word such as "angular momentum" or "w"; empty if there is none.
std::string figureOf(std::string_view word);

/// Reports unknown names of a document, in its order. A name of a textbook or of another program, and a key of
/// another table, get an example of the right key with the given value. Names that belong together, such as I1, I2
/// and I3, become one problem. Adds the keys for which such names stand to Leaves::meant.
/// @param leaves  all other values of the document
void reportUnknown(std::vector<UnknownName> names, Leaves& leaves, Problems& problems);

/// Returns advice for a value that suits another key, such as "; did you mean motion.L_body? ..." for three
/// numbers in place of motion.L. Empty if no key is known for the value.
std::string adviceFor(const std::string& path, const Node& value, Leaves& leaves);

}  // namespace poinsot::scene
