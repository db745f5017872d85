// SPDX-License-Identifier: Apache-2.0
#include "figure/svg_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace poinsot::figure {
namespace {

constexpr std::size_t kLongest = 40;
constexpr std::array<std::string_view, 6> kAlphabets{"mathbf", "boldsymbol", "mathrm", "mathit", "text", "textbf"};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string_view leadingLetters(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, isLetter);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

}  // namespace

std::string wordOf(std::string_view tex) {
  std::string word;
  const auto separate = [&] {
    if (!word.empty() && word.back() != '-') word += '-';
  };
  while (!tex.empty()) {
    if (tex.front() == '\\') {
      const std::string_view command = leadingLetters(tex.substr(1));
      separate();
      if (std::ranges::find(kAlphabets, command) == kAlphabets.end()) word += command;
      separate();
      tex.remove_prefix(std::min(tex.size(), 1 + std::max(command.size(), std::size_t{1})));
      continue;
    }
    if (isLetter(tex.front()) || isDigit(tex.front()))
      word += tex.front();
    else
      separate();
    tex.remove_prefix(1);
  }
  word.resize(std::min(word.size(), kLongest));
  while (word.ends_with('-')) word.pop_back();
  return word;
}

std::string SvgNames::take(const std::string& name) {
  std::string free = name;
  for (int i = 2; !taken_.insert(free).second; ++i) free = fmt::format("{}-{}", name, i);
  return free;
}

}  // namespace poinsot::figure
