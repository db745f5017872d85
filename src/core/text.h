// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::core {

/// One character of UTF-8 and how many bytes it took.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 0;  ///< 0 when the bytes are not UTF-8
};

/// The first character of `text`, which must not be empty. Overlong forms and surrogates are not UTF-8.
CodePoint firstCodePoint(std::string_view text);

/// Number of single-character edits (insert, delete, replace, swap of neighbours) from a to b.
int editDistance(std::string_view a, std::string_view b);

/// The candidate nearest to `word` if it is near enough to be what was meant (at most a third of its letters
/// differ, or two of five and more, and not all), else the first that contains it; for "did you mean".
std::optional<std::string> closest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the text without the blanks at its ends: spaces, tabs, and the carriage return of a line from Windows.
std::string_view trimmed(std::string_view text);

/// Returns the words with the separator between them. @param words  a range of strings or string views
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

/// Returns "; endings are in small letters: a.mp4" if only capitals keep the ending of the file name from being
/// one of `endings`; else an empty string. Append it to the message that refuses the name.
/// @param endings  with the dot
std::string smallLettersHint(std::string_view name, const std::vector<std::string>& endings);

/// Untrusted text made safe for a terminal, a log or a message: control characters, DEL, C1, bidi controls,
/// characters that are not seen, line separators and invalid UTF-8 become \xNN or \u{N}; cut at 200 characters
/// with an ellipsis.
std::string printable(std::string_view untrusted);

/// The same of text of several lines: line ends and tabs stay, and it is not cut.
std::string printableLines(std::string_view untrusted);

/// Returns the text as it stands between the tags of XML and HTML: & < and > are escaped.
std::string xmlText(std::string_view text);

/// The same for the value of an attribute: quotation marks, too.
std::string xmlAttribute(std::string_view text);

}  // namespace poinsot::core
