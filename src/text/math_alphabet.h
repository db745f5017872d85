// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// Shapes of letters. Unicode has characters of its own for each shape (block U+1D400).
enum class Alphabet {
  kMathItalic,  ///< the default of mathematics: slanted, but capital Greek upright, as in TeX
  kRoman,
  kBold,
  kBoldItalic,
  kText,      ///< running text: kRoman, with the marks of the font for text
  kBoldText,  ///< running text: kBold, with bold marks, punctuation and signs
};

constexpr Alphabet textAlphabet(bool bold) { return bold ? Alphabet::kBoldText : Alphabet::kText; }

/// Returns the character for `letter` in an alphabet; `letter` itself if it has no such form (operators, accented
/// letters).
char32_t inAlphabet(char32_t letter, Alphabet alphabet);

/// Reports whether the letter leans, so that its width must include the italic correction.
bool leans(char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
