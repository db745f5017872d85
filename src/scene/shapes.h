// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/solid.h"
#include "scene/keys/draft.h"

namespace poinsot::scene {

/// Keys that together describe a shape, such as size, or radius and height.
using KeyNames = std::vector<std::string_view>;

struct NamedShape {
  std::string_view word;
  std::string_view help;
  std::vector<KeyNames> ways;  ///< alternatives, one of which is given
  KeyNames optional{};
  std::size_t extents = 3;  ///< number of extents in `size`; 2 for a flat shape
  /// Makes the solid from the keys of one way. Empty for a shape read from a file. @pre the keys are given.
  std::function<physics::Solid(const ShapeDraft&)> make{};
  physics::Solid usual{};  ///< default proportions
};

const std::vector<NamedShape>& namedShapes();

std::vector<std::string_view> shapeWords();

/// Key for one length, the same in [body], [[body.part]] and [show.body].
struct LengthKey {
  std::string_view name;
  std::string_view help;
  std::string_view example;
  bool signedLength = false;  ///< may be zero or negative
};

const std::vector<LengthKey>& lengthKeys();

/// Returns the names of all shape keys in the order of the table: size, lengths, wing, file, file_unit.
const KeyNames& shapeKeyNames();

/// Joins names: "a", "a and b", "a, b and c".
std::string listed(const KeyNames& names);

/// Describes the keys of a shape: "size, or radius and height (and inner_radius, if wanted)".
std::string described(const NamedShape& shape);

}  // namespace poinsot::scene
