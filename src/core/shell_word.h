// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// Quotes a word for bash if necessary. Characters that a terminal would interpret become octal numbers, so that
/// the result is one line and safe to print, also in a here-document or after a #.
std::string shellWord(std::string_view word);

std::string shellWords(const std::vector<std::string>& words);

}  // namespace poinsot::core
