// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// Character of a UTF-8 text, and the number of bytes that it takes.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 0;  ///< 0 if the bytes are not UTF-8
};

/// Decodes the first character of `text`, which must not be empty. Overlong forms and surrogates are not UTF-8.
CodePoint firstCodePoint(std::string_view text);

/// Returns the number of single-character edits (insert, delete, replace, swap of neighbours) from `a` to `b`.
int editDistance(std::string_view a, std::string_view b);

/// Returns the candidate for "did you mean": the nearest to `word`, if at most max(n / 3, 1) of the word's n
/// letters differ (2 from n = 5 on), and not all. Otherwise returns the first that contains `word` or shares its
/// first five letters.
std::optional<std::string> closest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the text without spaces, tabs and carriage returns (of Windows lines) at its ends.
std::string_view trimmed(std::string_view text);

template <class Words>
std::string joined(const Words& words, std::string_view separator) {
  std::string text;
  bool first = true;
  for (const std::string_view word : words) {
    if (!first) text += separator;
    text += word;
    first = false;
  }
  return text;
}

/// Returns the text with its ASCII capitals as small letters.
std::string lowered(std::string_view text);

/// Returns "; endings are in small letters: a.mp4" if the ending of a file name is in `endings` except for
/// capitals; otherwise an empty string. Append the result to the message that rejects the name.
/// @param endings  with the dot
std::string smallLettersHint(std::string_view name, const std::vector<std::string>& endings);

/// Escapes untrusted text for a terminal, a log or a message. Control characters, DEL, C1, bidi controls,
/// invisible characters, line separators and invalid UTF-8 become \xNN or \u{N}. Cuts the text at 200 characters,
/// with an ellipsis.
std::string printable(std::string_view untrusted);

/// Escapes like printable(), but keeps line ends and tabs, and does not cut the text.
std::string printableLines(std::string_view untrusted);

/// Escapes & < and > for text between the tags of XML and HTML.
std::string xmlText(std::string_view text);

/// Escapes & < > and double quotes for the value of an XML or HTML attribute.
std::string xmlAttribute(std::string_view text);

}  // namespace poinsot::core
