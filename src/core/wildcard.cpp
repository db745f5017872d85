// SPDX-License-Identifier: Apache-2.0
#include "core/wildcard.h"

#include <cstddef>

namespace poinsot::core {

bool matchesWildcard(std::string_view pattern, std::string_view text) {
  // Greedy: only the last star is ever given more, so that the time is at most the product of both lengths.
  std::size_t p = 0, t = 0, star = std::string_view::npos, from = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace poinsot::core
