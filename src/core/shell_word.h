// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// Quotes a word for bash if necessary. Characters that are unsafe on a terminal become octal numbers. The result
/// is one line, and also safe in a here-document and after a #.
std::string shellWord(std::string_view word);

std::string shellWords(const std::vector<std::string>& words);

}  // namespace poinsot::core
