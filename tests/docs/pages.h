// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "support/text_of.h"

namespace poinsot {

/// README and what lies in docs/.
std::vector<std::filesystem::path> pages();

/// What stands between ```toml and ```, each block with its last line end.
std::vector<std::string> tomlBlocks(const std::string& markdown);

/// The equations n or n–m that begin the rows of a table in Markdown.
std::multiset<int> equationRows(const std::string& markdown);

}  // namespace poinsot
