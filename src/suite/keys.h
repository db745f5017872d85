// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::suite {

/// Key of a golden.toml with its documentation.
struct GoldenKey {
  const char* table;  ///< "" for the file itself, "test", "rule"
  const char* name;
  const char* value;  ///< accepted value: "text", "[width, height]"
  const char* help;
  const char* fallback;  ///< default, in words; empty if there is none
  const char* example;
};

/// Returns all keys, grouped by table. The table "rule" may stand in the file itself and in a test.
std::span<const GoldenKey> goldenKeys();

/// Returns the names of a table's keys, sorted.
std::vector<std::string> goldenKeysOf(std::string_view table);

}  // namespace poinsot::suite
