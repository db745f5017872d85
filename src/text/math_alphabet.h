// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// Style of letters and digits. Unicode has separate characters for the mathematical styles, from U+1D400 on.
enum class Alphabet {
  kMathItalic,  ///< default in formulas: slanted letters, but upright Greek capitals, as in TeX
  kRoman,
  kBold,
  kBoldItalic,
  kText,      ///< running text: kRoman, with accents of the text font
  kBoldText,  ///< running text: kBold, with bold accents, punctuation and symbols
};

constexpr Alphabet textAlphabet(bool bold) { return bold ? Alphabet::kBoldText : Alphabet::kText; }

/// Returns the character that represents `letter` in an alphabet. Returns `letter` itself if there is no such
/// character, as for operators and accented letters.
char32_t inAlphabet(char32_t letter, Alphabet alphabet);

/// Reports whether a letter is slanted in an alphabet. Its width then includes the italic correction.
bool leans(char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
