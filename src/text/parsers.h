// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "text/math_box.h"
#include "text/tex_reader.h"

namespace poinsot::text {

/// End of a list. The opening sign has been taken; errors name its column if the end is missing.
struct ListEnd {
  char32_t sign = 0;  ///< '}', '$' or ']', taken with the list; 0 for the end of the string
  std::size_t openedAt = 0;
};

struct TextStyle {
  bool bold = false;
  int level = 0;
  bool insideMath = false;  ///< inside \text{...}, where $...$ is not allowed
};

/// Parses running text up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseText(TexReader& reader, const TextStyle& style, const ListEnd& end);

/// Parses a formula up to `end`. @throws core::Error(kUsage) with the column of the mistake.
Box parseMath(TexReader& reader, const MathStyle& style, const ListEnd& end);

/// Reports whether the list ends here, and takes the end.
/// @throws core::Error(kUsage) if another end stands here, or the string ends too early.
bool takeEnd(TexReader& reader, const ListEnd& end);

[[noreturn]] void failUnknownCommand(const TexReader& reader, std::size_t column, const std::string& name);

/// Splits a letter and the marks that follow it into characters with glyphs (splitIntoGlyphs()). The letter has
/// been taken already; the marks are taken here.
/// @throws core::Error(kUsage) with the column of the character that no font has.
std::u32string takeLetter(TexReader& reader, char32_t letter, Alphabet alphabet);

}  // namespace poinsot::text
