// SPDX-License-Identifier: Apache-2.0
#include "core/wildcard.h"

#include <cstddef>

namespace poinsot::core {

namespace {

bool isEscape(std::string_view pattern, std::size_t p) {
  return pattern[p] == '\\' && p + 1 < pattern.size() && (pattern[p + 1] == '*' || pattern[p + 1] == '\\');
}

}  // namespace

bool matchesWildcard(std::string_view pattern, std::string_view text) {
  // Greedy match: only the last star grows. The time is at most the product of both lengths.
  std::size_t p = 0, t = 0, star = std::string_view::npos, from = 0;
  while (t < text.size()) {
    const bool escaped = p < pattern.size() && isEscape(pattern, p);
    const std::size_t letter = escaped ? p + 1 : p;
    if (p < pattern.size() && !escaped && pattern[p] == '*') {
      star = p++;
      from = t;
    } else if (letter < pattern.size() && pattern[letter] == text[t]) {
      p = letter + 1;
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

std::string wildcardOf(std::string_view text) {
  std::string pattern;
  for (const char c : text) pattern += c == '*' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return pattern;
}

}  // namespace poinsot::core
