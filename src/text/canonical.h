// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

/// Canonical equivalence: an accented letter is the same text as one character and as a letter with its marks. The
/// tables are HarfBuzz's. Source: The Unicode Standard, chapter 3.11.
namespace poinsot::text {

/// Reports whether the character is drawn on the one before it, such as an accent or a dot below.
bool isMark(char32_t character);

/// Place of a mark on its letter, by its canonical combining class.
enum class MarkPlace { kAbove, kBelow, kThrough };
MarkPlace placeOf(char32_t mark);

/// Decomposes every character completely, with marks in their canonical order (form NFD).
std::u32string decomposed(std::u32string_view text);

/// Composes each letter with as many of its marks as form a character that `has` accepts; the other marks follow.
/// If `has` accepts everything, the result is form NFC (except for Hangul). Equivalent texts give the same result.
std::u32string composed(std::u32string_view text, const std::function<bool(char32_t)>& has);

}  // namespace poinsot::text
