// SPDX-License-Identifier: Apache-2.0
#include "core/wildcard.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace poinsot::core {
namespace {

/// Matches by definition: a star stands for nothing, or for one character and another star.
bool byDefinition(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern[0] == '*')
    return byDefinition(pattern.substr(1), text) || (!text.empty() && byDefinition(pattern, text.substr(1)));
  return !text.empty() && pattern[0] == text[0] && byDefinition(pattern.substr(1), text.substr(1));
}

std::vector<std::string> words(const std::string& letters, int longest) {
  std::vector<std::string> all = {""};
  for (std::size_t from = 0; longest > 0; --longest) {
    const std::size_t to = all.size();
    for (; from < to; ++from)
      for (const char c : letters) all.push_back(all[from] + c);
  }
  return all;
}

TEST(Wildcard, AgreesWithARecursiveDefinition) {
  for (const std::string& pattern : words("ab*", 4))
    for (const std::string& text : words("ab", 5))
      EXPECT_EQ(matchesWildcard(pattern, text), byDefinition(pattern, text)) << pattern << " / " << text;
}

TEST(Wildcard, MatchesBracketsLiterally) {
  EXPECT_TRUE(matchesWildcard("test_wave[1]", "test_wave[1]"));
  EXPECT_FALSE(matchesWildcard("test_wave[1]", "test_wave1"));
  EXPECT_TRUE(matchesWildcard("test_*[*]", "test_wave[1]"));
}

TEST(Wildcard, EscapedTextMatchesOnlyItself) {
  const auto all = words("a*\\", 4);
  for (const std::string& one : all)
    for (const std::string& other : all)
      EXPECT_EQ(matchesWildcard(wildcardOf(one), other), one == other) << one << " / " << other;
}

TEST(Wildcard, MatchesManyStarsQuickly) {
  const std::string text(20000, 'a');
  EXPECT_FALSE(matchesWildcard("*a*a*a*a*a*a*a*a*a*a*b", text));
}

}  // namespace
}  // namespace poinsot::core
