// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// The shapes a letter comes in; Unicode gives each its own characters (block U+1D400).
enum class Alphabet {
  kMathItalic,  ///< the default of mathematics: slanted, but capital Greek upright, as TeX has it
  kRoman,
  kBold,
  kBoldItalic,
  kText,      ///< of running text: as kRoman, with the marks of the font for text
  kBoldText,  ///< of running text: as kBold, and its marks, punctuation and signs are bold too
};

/// The alphabet of running text.
constexpr Alphabet textAlphabet(bool bold) { return bold ? Alphabet::kBoldText : Alphabet::kText; }

/// The character for `letter` in that shape; `letter` itself where it has no such form (operators, accented
/// letters).
char32_t inAlphabet(char32_t letter, Alphabet alphabet);

/// Whether the letter leans, so that its italic correction is room it needs.
bool leans(char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
