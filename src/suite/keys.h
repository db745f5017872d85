// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::suite {

/// Key that golden.toml may contain, with its documentation.
struct GoldenKey {
  const char* table;  ///< "test", "rule", or "" for a key outside of tables
  const char* name;
  const char* value;  ///< accepted value, such as "text" or "[width, height]"
  const char* help;
  const char* fallback;  ///< default, in words; empty if there is none
  const char* example;
};

/// Returns all keys, grouped by table. The table "rule" is allowed at the top level and in a test.
std::span<const GoldenKey> goldenKeys();

/// Returns the names of a table's keys, sorted.
std::vector<std::string> goldenKeysOf(std::string_view table);

}  // namespace poinsot::suite
