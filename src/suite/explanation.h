// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/explanation.h"
#include "suite/keys.h"

namespace poinsot::suite {

/// Returns the path of a key in its file: "references", "test.image", "rule.max".
std::string pathInFile(const GoldenKey& key);

/// Returns the path by which a key is explained: "golden.references", "golden.test.image", "golden.rule.max".
std::string pathOf(const GoldenKey& key);

/// Explains names of a golden.toml: all of it ("golden"), a table ("golden.test", "[[test]]", "rule"), a key
/// ("golden.rule.max", "test.rule.max", "flip_max"). Empty for other words.
std::vector<scene::Explanation> explainGolden(std::string_view word);

/// Words that explainGolden() takes.
std::vector<std::string> goldenWords();

/// The keys as a table in Markdown for each table of the file, as docs/golden.md has them.
std::string goldenKeysMarkdown();

}  // namespace poinsot::suite
