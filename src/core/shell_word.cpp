// SPDX-License-Identifier: Apache-2.0
#include "core/shell_word.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::core {
namespace {

/// Returns whether a word is safe to print on a terminal without escapes, on one line.
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

/// Quotes a word as $'...', with control characters and non-ASCII bytes as octal numbers. Octal numbers always
/// have three digits, because a following digit of the word would otherwise become part of the number.
std::string inNumberedQuotes(std::string_view word) {
  std::string text = "$'";
  for (const char c : word)
    if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte >= 0x7f)
      text += fmt::format("\\{:03o}", byte);
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
