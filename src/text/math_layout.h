// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "text/math_box.h"

/// How parts of a formula are put together, by the font's MATH table.
/// Source: OpenType 1.9, "MATH - the mathematical typesetting table"; The TeXbook, appendix G.
namespace poinsot::text {

/// What part a piece of a formula plays; the space around it follows.
enum class AtomClass { kOrdinary, kFunction, kBinary, kRelation, kOpening, kClosing, kPunctuation, kInner };

/// Space between two neighbours in em of the current size: thin 3/18, medium 4/18 (around + - ×), thick 5/18
/// (around = < →). In scripts only functions keep theirs. Source: D. E. Knuth, The TeXbook, chapter 18, the table
/// of atom spacing.
double spaceBetween_em(AtomClass left, AtomClass right, bool inScript);

/// Whether a binary operator between these two is only a sign (as in "-1", "= -x"): then it is ordinary.
bool isSign(const AtomClass* left, const AtomClass* right);

/// A box and its part in the formula; a space has no part and lets its neighbours see each other.
struct Atom {
  Box box;
  AtomClass atomClass = AtomClass::kOrdinary;
  bool isSpace = false;
};

/// Atoms in a row with the space their classes ask for.
Box joined(const std::vector<Atom>& atoms, const MathStyle& style);

/// What is attached to a base. Primes stand at the base's own size, before a superscript.
struct Scripts {
  std::optional<Box> sub;
  std::optional<Box> sup;
  std::optional<Box> primes;
};
Box withScripts(const Box& base, const Scripts& scripts, const MathStyle& style);

/// With `display`, as wide apart as in an equation of its own.
Box fraction(const Box& numerator, const Box& denominator, const MathStyle& style, bool display);

/// Empty where `content` is taller than the font's largest root sign.
std::optional<Box> squareRoot(const Box& content, const MathStyle& style);

/// Sets the index of a root, such as the 3 of a cube root, on the left arm of `root`, a squareRoot().
Box withIndex(const Box& root, const Box& index, const MathStyle& style);

}  // namespace poinsot::text
