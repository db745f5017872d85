// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// Decoded character of a UTF-8 text, with its length in bytes.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 0;  ///< bytes of the character; 0 if the bytes are not UTF-8
};

/// Decodes the first character of `text`, which must not be empty. Rejects overlong forms and surrogates.
CodePoint firstCodePoint(std::string_view text);

/// Returns the number of single-character edits that turn `a` into `b`. An edit inserts, deletes or replaces a
/// character, or swaps two neighbours.
int editDistance(std::string_view a, std::string_view b);

/// Returns the suggestion for "did you mean". Prefers the candidate nearest to `word`: for a word of n letters, at
/// most max(n / 3, 1) letters may differ (2 from n = 5 on), but never all. Otherwise returns the first candidate
/// that contains `word`, or that shares its first five letters.
std::optional<std::string> closest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the text without spaces, tabs and carriage returns at its ends.
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

/// Returns the text with ASCII capitals in lower case.
std::string lowered(std::string_view text);

/// Returns "; write the ending in lower case: a.mp4" if the ending of a file name matches one of `endings` except
/// for capitals. Otherwise returns an empty text. Append the result to the message that rejects the file name.
/// @param endings  file name endings with the dot, in lower case
std::string smallLettersHint(std::string_view name, const std::vector<std::string>& endings);

/// Escapes untrusted text for a terminal, a log or a message. Control characters, DEL, C1, bidi controls,
/// invisible characters, line separators and invalid UTF-8 become \xNN or \u{N}. Cuts the text at 200 characters
/// and adds an ellipsis.
std::string printable(std::string_view untrusted);

/// Escapes text like printable(), but keeps newlines and tabs, and never cuts the text.
std::string printableLines(std::string_view untrusted);

/// Escapes & < and > for text between the tags of XML and HTML.
std::string xmlText(std::string_view text);

/// Escapes & < > and double quotes for the value of an XML or HTML attribute.
std::string xmlAttribute(std::string_view text);

}  // namespace poinsot::core
