// SPDX-License-Identifier: Apache-2.0
#include "cli/paragraph.h"

#include <algorithm>

namespace poinsot::cli {
namespace {

/// Characters, not bytes.
std::size_t length(std::string_view word) {
  return static_cast<std::size_t>(
      std::ranges::count_if(word, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

std::string wrapped(std::string_view paragraph, std::size_t width, std::size_t indent, std::size_t column) {
  std::string text;
  bool begun = false;  // whether the line has a word
  for (std::size_t from = 0; from < paragraph.size();) {
    const std::size_t to = std::min(paragraph.find_first_of(" \n", from), paragraph.size());
    const std::string_view word = paragraph.substr(from, to - from);
    const bool newLine = from > 0 && paragraph[from - 1] == '\n';
    if (newLine || (begun && column + 1 + length(word) > width)) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (begun) {
      text += ' ';
      ++column;
    }
    text += word;
    column += length(word);
    begun = true;
    from = to + 1;
  }
  return text;
}

}  // namespace poinsot::cli
