// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "text/math_box.h"

/// Layout of formulas by the font's MATH table.
/// Source: OpenType 1.9, "MATH - the mathematical typesetting table"; The TeXbook, appendix G.
namespace poinsot::text {

/// Role of a piece of a formula, which decides the space around it.
enum class AtomClass { kOrdinary, kFunction, kBinary, kRelation, kOpening, kClosing, kPunctuation, kInner };

/// Returns the space between two neighbours in em of the current size: thin 3/18, medium 4/18 (around + - ×),
/// thick 5/18 (around = < →). In scripts only functions keep theirs. Source: D. E. Knuth, The TeXbook, chapter 18,
/// the table of atom spacing.
double spaceBetween_em(AtomClass left, AtomClass right, bool inScript);

/// Reports whether a binary operator between two neighbours (null if missing) is only a sign, as in "-1" or "=
/// -x".
bool isSign(const AtomClass* left, const AtomClass* right);

/// Box with its role in a formula. A space has no role, and its neighbours are spaced as if it were absent.
struct Atom {
  Box box;
  AtomClass atomClass = AtomClass::kOrdinary;
  bool isSpace = false;
};

/// Sets atoms in a row, with the space between their classes.
Box joined(const std::vector<Atom>& atoms, const MathStyle& style);

/// Scripts of a base. Primes stand at the base's own size, before a superscript.
struct Scripts {
  std::optional<Box> sub;
  std::optional<Box> sup;
  std::optional<Box> primes;
};
Box withScripts(const Box& base, const Scripts& scripts, const MathStyle& style);

/// Sets a fraction. With `display`, its parts are as wide apart as in an equation of its own line.
Box fraction(const Box& numerator, const Box& denominator, const MathStyle& style, bool display);

/// Sets `content` under a root; nullopt if `content` is taller than the font's largest root sign.
std::optional<Box> squareRoot(const Box& content, const MathStyle& style);

/// Sets the index of a root, such as the 3 of a cube root, on the left arm of `root`, a result of squareRoot().
Box withIndex(const Box& root, const Box& index, const MathStyle& style);

}  // namespace poinsot::text
