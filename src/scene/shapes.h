// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/solid.h"
#include "scene/keys/draft.h"

/// The words for shapes and which keys describe each.
namespace poinsot::scene {

/// Keys that describe a shape together: size, or radius and height.
using KeyNames = std::vector<std::string_view>;

struct NamedShape {
  std::string_view word;
  std::string_view help;       ///< where its origin and its axes are
  std::vector<KeyNames> ways;  ///< any one of them
  KeyNames optional{};
  std::size_t extents = 3;  ///< how many `size` has; 2 of what is flat
  /// From the keys of one way. @pre they are given. Empty for what is read from a file.
  std::function<physics::Solid(const ShapeDraft&)> make{};
  physics::Solid usual{};  ///< what it looks like where nothing is said
};

const std::vector<NamedShape>& namedShapes();

std::vector<std::string_view> shapeWords();

/// A key for one length, the same after body, body.part[] and show.body.
struct LengthKey {
  std::string_view name;
  std::string_view help;
  std::string_view example;
  bool signedLength = false;  ///< may be zero or negative
};

const std::vector<LengthKey>& lengthKeys();

/// Names of all keys that describe shapes, in the order of the table: size, lengths, wing, file, file_unit.
const KeyNames& shapeKeyNames();

/// "a", "a and b", "a, b and c".
std::string listed(const KeyNames& names);

/// "size, or radius and height (and inner_radius, if wanted)".
std::string described(const NamedShape& shape);

}  // namespace poinsot::scene
