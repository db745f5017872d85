// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

/// Canonical equivalence of Unicode texts: an accented letter is the same text whether it is written as one
/// character or as a letter and marks. The tables are HarfBuzz's. Source: The Unicode Standard, chapter 3.11.
namespace poinsot::text {

/// Reports whether a character is a mark, such as an accent, which is drawn on the character before it.
bool isMark(char32_t character);

/// Position of a mark relative to its letter, from its canonical combining class.
enum class MarkPlace { kAbove, kBelow, kThrough };
MarkPlace placeOf(char32_t mark);

/// Splits every character into its base letter and marks, with the marks in canonical order (form NFD).
std::u32string decomposed(std::u32string_view text);

/// Composes each letter with its marks to one character if `has` accepts the character. Other marks follow. If
/// `has` accepts everything, the result is form NFC (except for Hangul). Equivalent texts have equal results.
std::u32string composed(std::u32string_view text, const std::function<bool(char32_t)>& has);

}  // namespace poinsot::text
