// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// A word as bash reads it back: bare where that is safe, else in quotes. What a terminal would obey
/// is written as numbers, so that the result can be shown, and is always one line, in a here-document and behind a
/// # too.
std::string shellWord(std::string_view word);

/// Words with spaces between them.
std::string shellWords(const std::vector<std::string>& words);

}  // namespace poinsot::core
