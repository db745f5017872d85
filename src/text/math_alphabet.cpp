// SPDX-License-Identifier: Apache-2.0
#include "text/math_alphabet.h"

#include <string_view>

namespace poinsot::text {
namespace {

// Variants of Greek letters. In Unicode's mathematical alphabets they follow the letter ω in this order.
constexpr std::u32string_view kGreekVariants = U"∂ϵϑϰϕϱϖ";

// First characters of the ranges of one mathematical alphabet (Unicode chapter 22.2). 0 for plain characters.
struct Starts {
  char32_t capital = 0;
  char32_t small = 0;
  char32_t digit = 0;
  char32_t greekCapital = 0;
  char32_t greekSmall = 0;  // the 25 letters α to ω, with ς; kGreekVariants follow them
};

Starts startsOf(Alphabet alphabet) {
  switch (alphabet) {
    case Alphabet::kMathItalic:
      return {U'\U0001D434', U'\U0001D44E', 0, 0, U'\U0001D6FC'};
    case Alphabet::kRoman:
    case Alphabet::kText:
      return {};
    case Alphabet::kBold:
    case Alphabet::kBoldText:
      return {U'\U0001D400', U'\U0001D41A', U'\U0001D7CE', U'\U0001D6A8', U'\U0001D6C2'};
    case Alphabet::kBoldItalic:
      return {U'\U0001D468', U'\U0001D482', U'\U0001D7CE', U'\U0001D6A8', U'\U0001D736'};
  }
  return {};
}

bool between(char32_t c, char32_t first, char32_t last) { return c >= first && c <= last; }

char32_t shifted(char32_t c, char32_t from, char32_t to) { return to == 0 ? c : to + (c - from); }

}  // namespace

char32_t inAlphabet(char32_t letter, Alphabet alphabet) {
  // The code of the mathematical italic h is unassigned, because Unicode already had Planck's constant.
  if (letter == U'h' && alphabet == Alphabet::kMathItalic) return U'ℎ';
  const Starts starts = startsOf(alphabet);
  if (between(letter, U'A', U'Z')) return shifted(letter, U'A', starts.capital);
  if (between(letter, U'a', U'z')) return shifted(letter, U'a', starts.small);
  if (between(letter, U'0', U'9')) return shifted(letter, U'0', starts.digit);
  if (letter == U'\u03A2') return letter;  // unassigned code: the final sigma has no capital letter
  if (between(letter, U'Α', U'Ω')) return shifted(letter, U'Α', starts.greekCapital);
  if (between(letter, U'α', U'ω')) return shifted(letter, U'α', starts.greekSmall);
  const auto variant = kGreekVariants.find(letter);
  if (variant == kGreekVariants.npos || starts.greekSmall == 0) return letter;
  return starts.greekSmall + 25 + static_cast<char32_t>(variant);
}

bool leans(char32_t letter, Alphabet alphabet) {
  const bool italic = alphabet == Alphabet::kMathItalic || alphabet == Alphabet::kBoldItalic;
  return italic && inAlphabet(letter, alphabet) != letter && !between(letter, U'0', U'9') &&
         !between(letter, U'Α', U'Ω');
}

}  // namespace poinsot::text
