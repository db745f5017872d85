// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "text/math_box.h"
#include "text/math_spacing.h"

/// How parts of a formula are put together, by the font's MATH table.
/// Source: OpenType 1.9, "MATH - the mathematical typesetting table"; The TeXbook, appendix G.
namespace poinsot::text {

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
