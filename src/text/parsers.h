// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "text/math_box.h"
#include "text/tex_reader.h"

namespace poinsot::text {

/// Sign that ends a part of the text, such as the brace after a group. The opening sign has already been read.
struct ListEnd {
  char32_t sign = 0;  ///< '}', '$' or ']', which is read with the part; 0 for the end of the text
  std::size_t openedAt = 0;
};

struct TextStyle {
  bool bold = false;
  int level = 0;
  bool insideMath = false;  ///< whether the text is inside \text{...} of a formula, where $...$ is not allowed
};

/// Parses running text up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseText(TexReader& reader, const TextStyle& style, const ListEnd& end);

/// Parses a formula up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseMath(TexReader& reader, const MathStyle& style, const ListEnd& end);

/// If `end` comes next, reads it and returns true. Otherwise returns false.
/// @throws core::Error(kUsage) if another end comes next, or the text ends too early.
bool takeEnd(TexReader& reader, const ListEnd& end);

[[noreturn]] void failUnknownCommand(const TexReader& reader, std::size_t column, const std::string& name);

/// Returns a letter and its marks as characters that have glyphs (see splitIntoGlyphs()). The letter has already
/// been read; this function reads the marks that follow.
/// @throws core::Error(kUsage) with the column of the character that no font has.
std::u32string takeLetter(TexReader& reader, char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
