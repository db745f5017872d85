// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "scene/source.h"

namespace poinsot::scene {

// Limits on a scene's text, so that no file can exhaust the stack or the memory of what reads it.
constexpr std::size_t kMostBytes = 4 << 20;
constexpr std::size_t kLongestString = 64 << 10;  ///< bytes, as written
constexpr int kDeepestNesting = 64;               ///< tables and arrays in one another
constexpr int kMostNodes = 100'000;               ///< tables, arrays, values and their keys' parts

struct Entry;
struct DateOrTime {};

/// A TOML value and where it stands.
struct Node {
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;

  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Table> value;
  Place place;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
};

struct Entry {
  std::string key;
  Place keyPlace;
  Node value;
};

/// Reads TOML 1.0 within the limits above. The one door to toml++.
/// @throws SceneErrors with the one problem that stopped it: a syntax error, a key given twice, a limit.
Node parseDocument(const Source& source);

/// What was got, for a message: `"abc"`, `3.5`, `an array of 2`; safe to print.
std::string describe(const Node& node);

}  // namespace poinsot::scene
