// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "support/text_of.h"

namespace poinsot {

/// Returns README.md and the pages in docs/.
std::vector<std::filesystem::path> pages();

/// Returns the texts between ```toml and ```, each with its last line end.
std::vector<std::string> tomlBlocks(const std::string& markdown);

/// Returns the equations n or n–m that begin the rows of tables in Markdown.
std::multiset<int> equationRows(const std::string& markdown);

}  // namespace poinsot
