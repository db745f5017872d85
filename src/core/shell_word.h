// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// A word as bash reads it back: bare where that is safe, else in quotes. Control characters are written as
/// numbers, so that the result is always one line, in a here-document and behind a # too.
std::string shellWord(std::string_view word);

/// Words with spaces between them.
std::string shellWords(const std::vector<std::string>& words);

}  // namespace poinsot::core
