// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "text/math_box.h"

/// Layout of formulas with the font's MATH table. Sources: OpenType 1.9, "MATH - the mathematical typesetting
/// table"; The TeXbook, appendix G.
namespace poinsot::text {

/// Role of a piece of a formula, such as operator or relation. It determines the space around the piece.
enum class AtomClass { kOrdinary, kFunction, kBinary, kRelation, kOpening, kClosing, kPunctuation, kInner };

/// Returns the space between two neighbours, in em of the current size: 3/18 (thin), 4/18 (medium, around + - ×)
/// or 5/18 (thick, around = < →). In scripts, only functions such as \sin have space.
/// Source: D. E. Knuth, The TeXbook, chapter 18, the table of atom spacing.
double spaceBetween_em(AtomClass left, AtomClass right, bool inScript);

/// Reports whether a binary operator is only a sign, as in "-1" or "= -x".
/// @param left  class of the left neighbour; null if there is none
bool isSign(const AtomClass* left, const AtomClass* right);

/// Box with its role in a formula. A space has no role and does not change its neighbours' spacing.
struct Atom {
  Box box;
  AtomClass atomClass = AtomClass::kOrdinary;
  bool isSpace = false;
};

/// Typesets atoms in a row, with the space that their classes require between them.
Box joined(const std::vector<Atom>& atoms, const MathStyle& style);

/// Scripts of a base. Primes have the size of the base and come before the superscript.
struct Scripts {
  std::optional<Box> sub;
  std::optional<Box> sup;
  std::optional<Box> primes;
};
Box withScripts(const Box& base, const Scripts& scripts, const MathStyle& style);

/// Typesets a fraction. With `display`, numerator and denominator are as far apart as in a displayed equation.
Box fraction(const Box& numerator, const Box& denominator, const MathStyle& style, bool display);

/// Typesets a matrix in square brackets, centred on the axis of the line. Columns are flush right, so that numbers
/// with equally many decimals are aligned. Rows may have different lengths.
Box bracketedMatrix(const std::vector<std::vector<Box>>& rows, const MathStyle& style);

/// Typesets `content` under a root sign. Returns nullopt if `content` is taller than the font's largest root sign.
std::optional<Box> squareRoot(const Box& content, const MathStyle& style);

/// Adds an index to a root, such as the 3 of a cube root.
/// @param root  result of squareRoot()
Box withIndex(const Box& root, const Box& index, const MathStyle& style);

}  // namespace poinsot::text
