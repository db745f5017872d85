// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "text/math_box.h"
#include "text/tex_reader.h"

namespace poinsot::text {

/// Where a list ends. The opening sign has been taken; its column is named if the end is missing.
struct ListEnd {
  char32_t sign = 0;  ///< '}' or '$', taken with the list; 0 is the end of the string
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

/// @throws core::Error(kUsage) where the font has no glyph for what stands at `column`.
void requireGlyph(const TexReader& reader, std::size_t column, char32_t character);

}  // namespace poinsot::text
