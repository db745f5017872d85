// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace poinsot {

std::string textOf(const std::filesystem::path& file);

/// The equations n or n–m that begin the rows of a table in Markdown.
std::multiset<int> equationRows(const std::string& markdown);

}  // namespace poinsot
