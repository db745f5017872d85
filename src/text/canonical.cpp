// SPDX-License-Identifier: Apache-2.0
#include "text/canonical.h"

#include <hb.h>

#include <algorithm>

namespace poinsot::text {
namespace {

unsigned classOf(char32_t character) {
  return static_cast<unsigned>(hb_unicode_combining_class(hb_unicode_funcs_get_default(), character));
}

void appendDecomposed(std::u32string& result, char32_t character) {
  hb_codepoint_t first = 0, second = 0;
  if (!hb_unicode_decompose(hb_unicode_funcs_get_default(), character, &first, &second)) {
    result += character;
    return;
  }
  appendDecomposed(result, first);
  if (second != 0) appendDecomposed(result, second);
}

void sortMarks(std::u32string& text) {
  for (auto begin = text.begin(); begin != text.end();) {
    begin = std::find_if(begin, text.end(), isMark);
    const auto end = std::find_if_not(begin, text.end(), isMark);
    std::ranges::stable_sort(begin, end, {}, classOf);
    begin = end;
  }
}

// Returns the letter composed with as many of its marks as `has` accepts. A mark is not composed if another mark
// of its class remains before it.
std::u32string composedLetter(std::u32string_view letter, const std::function<bool(char32_t)>& has) {
  std::u32string best(letter), left;
  hb_codepoint_t whole = letter.front(), joined = 0;
  for (std::size_t i = 1; i < letter.size(); ++i) {
    const bool blocked = !left.empty() && classOf(left.back()) == classOf(letter[i]);
    if (blocked || !hb_unicode_compose(hb_unicode_funcs_get_default(), whole, letter[i], &joined)) {
      left += letter[i];
      continue;
    }
    whole = joined;
    if (has(whole)) best = static_cast<char32_t>(whole) + left + std::u32string(letter.substr(i + 1));
  }
  return best;
}

}  // namespace

bool isMark(char32_t character) { return classOf(character) != 0; }

// Distinguishes only the combining classes of the marks in the embedded fonts. Source: UAX #44, table 15.
MarkPlace placeOf(char32_t mark) {
  switch (classOf(mark)) {
    case HB_UNICODE_COMBINING_CLASS_ABOVE:
      return MarkPlace::kAbove;
    case HB_UNICODE_COMBINING_CLASS_BELOW:
      return MarkPlace::kBelow;
    default:
      return MarkPlace::kThrough;
  }
}

std::u32string decomposed(std::u32string_view text) {
  std::u32string result;
  for (const char32_t c : text) appendDecomposed(result, c);
  sortMarks(result);
  return result;
}

std::u32string composed(std::u32string_view text, const std::function<bool(char32_t)>& has) {
  const std::u32string parts = decomposed(text);
  std::u32string result;
  for (auto begin = parts.begin(); begin != parts.end();) {
    const auto end = std::find_if_not(begin + 1, parts.end(), isMark);
    result += composedLetter({begin, end}, has);
    begin = end;
  }
  return result;
}

}  // namespace poinsot::text
