// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/solid.h"
#include "scene/keys/draft.h"

namespace poinsot::scene {

/// Names of keys that together describe a shape, such as radius and height.
using KeyNames = std::vector<std::string_view>;

struct NamedShape {
  std::string_view word;
  std::string_view help;
  std::vector<KeyNames> ways;  ///< sets of keys, of which a scene gives one
  KeyNames optional{};
  std::size_t extents = 3;  ///< number of extents in the key `size`; 2 for a flat shape
  /// Function that makes the solid from one set of keys in `ways`. Empty for a shape that is read from a file.
  /// @pre the keys are given.
  std::function<physics::Solid(const ShapeDraft&)> make{};
  physics::Solid usual{};  ///< default proportions
};

const std::vector<NamedShape>& namedShapes();

std::vector<std::string_view> shapeWords();

/// Key for a length of a shape. The tables [body], [[body.part]] and [show.body] have the same keys.
struct LengthKey {
  std::string_view name;
  std::string_view help;
  std::string_view example;
  bool signedLength = false;  ///< whether the length may be zero or negative
};

const std::vector<LengthKey>& lengthKeys();

/// Returns the names of all keys of shapes, in the order of the table: size, lengths, wing, file, file_unit.
const KeyNames& shapeKeyNames();

/// Joins names as in a sentence: "a", "a and b", "a, b and c".
std::string listed(const KeyNames& names);

/// Lists the keys of a shape for a message, such as "size, or radius and height (and inner_radius, if wanted)".
std::string described(const NamedShape& shape);

}  // namespace poinsot::scene
