// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "text/math_box.h"
#include "text/tex_reader.h"

namespace poinsot::text {

/// Where a list ends. The opening sign has been taken; its column is named if the end is missing.
struct ListEnd {
  char32_t sign = 0;  ///< '}', '$' or ']', taken with the list; 0 is the end of the string
  std::size_t openedAt = 0;
};

struct TextStyle {
  bool bold = false;
  int level = 0;
  bool insideMath = false;  ///< of \text{...}: no $...$ within
};

/// Running text up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseText(TexReader& reader, const TextStyle& style, const ListEnd& end);

/// A formula up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseMath(TexReader& reader, const MathStyle& style, const ListEnd& end);

// ---- shared by the two --------------------------------------------------------------------------------------

/// Whether the list ends here; takes its end.
/// @throws core::Error(kUsage) where another end stands, or the string is over too early.
bool takeEnd(TexReader& reader, const ListEnd& end);

[[noreturn]] void failUnknownCommand(const TexReader& reader, std::size_t column, const std::string& name);

/// Splits a letter and the marks that follow it into characters with glyphs (splitIntoGlyphs()); the letter has
/// been taken, the marks are taken here.
/// @throws core::Error(kUsage) with the column of the character that no font has.
std::u32string takeLetter(TexReader& reader, char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
