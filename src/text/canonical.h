// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

/// Canonical equivalence: an accented letter is the same text as one character and as a letter with its marks.
/// The tables are HarfBuzz's. Source: The Unicode Standard, chapter 3.11.
namespace poinsot::text {

/// Whether the character is drawn on the one before it: an accent, a dot below.
bool isMark(char32_t character);

/// Where a mark lies on its letter, by its canonical combining class.
enum class MarkPlace { kAbove, kBelow, kThrough };
MarkPlace placeOf(char32_t mark);

/// Every character taken apart as far as possible, marks in their canonical order (form NFD).
std::u32string decomposed(std::u32string_view text);

/// Each letter joined with as many of its marks as make a character that `has` accepts; the other marks follow it.
/// If `has` accepts everything, this is form NFC (but for Hangul). Equivalent texts give the same result.
std::u32string composed(std::u32string_view text, const std::function<bool(char32_t)>& has);

}  // namespace poinsot::text
