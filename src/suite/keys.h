// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::suite {

/// A key of a golden.toml, for people who write one.
struct GoldenKey {
  const char* table;  ///< "" of the file itself, "test", "rule"
  const char* name;
  const char* value;  ///< what it takes: "text", "[width, height]"
  const char* help;
  const char* fallback;  ///< what holds without it; empty: nothing
  const char* example;   ///< value that a manifest may have
};

/// All keys, by table. A rule may stand in the file itself and in a test.
std::span<const GoldenKey> goldenKeys();

/// Names of the keys of a table, sorted.
std::vector<std::string> goldenKeysOf(std::string_view table);

}  // namespace poinsot::suite
