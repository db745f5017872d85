// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

struct Entry;
struct DateOrTime {};

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

/// Parses TOML 1.0. Checks the limits on text before, so that no file can exhaust the stack or the memory. No
/// other part of the program uses the library toml++.
/// @throws SceneErrors with one problem, at which the parser stops: a syntax error, a repeated key, or a limit.
Node parseDocument(const Source& source, const Limits& limits = {});

/// Document with all parts of a text that could be read.
struct PartialDocument {
  Node root;
  std::set<std::string, std::less<>> broken{};  ///< top-level tables with lines left out; "" for an unknown table
};

/// Parses TOML like parseDocument(), but continues after a syntax error without the lines that contain it.
/// @param problems  receives all syntax errors
/// @throws SceneErrors if the text exceeds a limit.
PartialDocument parseValidParts(const Source& source, const Limits& limits, Problems& problems);

/// Writes a value as TOML on one line.
/// @pre it holds no date or time.
std::string tomlText(const Node& node);

/// Describes a value for a message, such as `"abc"`, `3.5` or `an array of 2`. The text is safe to print.
std::string describe(const Node& node);

}  // namespace poinsot::scene
