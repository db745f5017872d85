// SPDX-License-Identifier: Apache-2.0
#include "core/shell_word.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::core {
namespace {

/// Returns whether a word can be shown unchanged: it is one line, and safe on a terminal.
bool isShown(std::string_view word) {
  return word.find_first_of("\n\t") == std::string_view::npos && printableLines(word) == word;
}

bool isPlain(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return letter || std::string_view("_./:=@%+,-").find(c) != std::string_view::npos;
}

std::string inSingleQuotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// Quotes a word as $'...', with bytes as octal numbers. Always three digits, so that a following digit stays
/// separate.
std::string inNumberedQuotes(std::string_view word) {
  std::string text = "$'";
  for (const char c : word)
    if (c < 0x20 || c == 0x7f)  // includes bytes that are not ASCII: they are negative
      text += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    else
      text += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string shellWord(std::string_view word) {
  if (!word.empty() && std::ranges::all_of(word, isPlain)) return std::string(word);
  return isShown(word) ? inSingleQuotes(word) : inNumberedQuotes(word);
}

std::string shellWords(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shellWord(word);
  return text;
}

}  // namespace poinsot::core
