// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/explanation.h"
#include "suite/keys.h"

namespace poinsot::suite {

/// Returns the path of a key in its file, such as "references", "test.image" or "rule.max".
std::string pathInFile(const GoldenKey& key);

/// Returns the full path of a key, such as "golden.references", "golden.test.image" or "golden.rule.max".
std::string pathOf(const GoldenKey& key);

/// Explains a name that golden.toml may contain: the file ("golden"), a table ("golden.test", "[[test]]", "rule"),
/// or a key ("golden.rule.max", "test.rule.max", "flip_max"). Returns an empty list for an unknown name.
std::vector<scene::Explanation> explainGolden(std::string_view word);

/// Returns the names that explainGolden() accepts: paths of tables and keys, and bare names of keys.
std::vector<std::string> goldenWords();

/// Returns the documentation of all keys in Markdown, one table for each table of the file. docs/golden.md
/// contains this text.
std::string goldenKeysMarkdown();

}  // namespace poinsot::suite
