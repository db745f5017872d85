// SPDX-License-Identifier: Apache-2.0
#include "text/tex_reader.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/expect.h"
#include "core/text.h"

namespace poinsot::text {
namespace {

// Largest number of characters in a label or a title. A longer text is a mistake and would not fit a picture.
constexpr std::size_t kMostCharacters = 2000;
constexpr int kDeepest = 40;

bool isNameLetter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

}  // namespace

bool isBlank(char32_t c) { return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r'; }

TexReader::TexReader(std::string_view tex) : tex_(tex) {
  while (!tex.empty()) {
    const core::CodePoint next = core::firstCodePoint(tex);
    if (next.length == 0) fail(characters_.size() + 1, "not valid UTF-8; save the file as UTF-8");
    if (characters_.size() == kMostCharacters)
      fail(kMostCharacters + 1, fmt::format("too long; at most {} characters", kMostCharacters));
    characters_ += next.value;
    tex.remove_prefix(next.length);
  }
}

char32_t TexReader::take() {
  POINSOT_EXPECT(!atEnd());
  return characters_[position_++];
}

bool TexReader::takeIf(char32_t wanted) {
  if (atEnd() || peek() != wanted) return false;
  ++position_;
  return true;
}

bool TexReader::isAt(std::u32string_view characters) const {
  return std::u32string_view(characters_).substr(position_).starts_with(characters);
}

bool TexReader::takeIf(std::u32string_view wanted) {
  if (!isAt(wanted)) return false;
  position_ += wanted.size();
  return true;
}

std::string TexReader::takeName() {
  if (atEnd()) fail(position_, "a backslash at the end; it starts a command such as \\omega");
  std::string name;
  while (isNameLetter(peek())) name += static_cast<char>(take());
  if (!name.empty()) {
    skipBlanks();  // spaces after a command name are skipped, as in TeX
    return name;
  }
  const char32_t sign = peek();
  if (sign >= 0x7f || (sign < 0x20 && !isBlank(sign)))
    fail(position_, "a backslash before a character that is not a command");
  take();
  return std::string(1, isBlank(sign) ? ' ' : static_cast<char>(sign));
}

void TexReader::skipBlanks() {
  while (isBlank(peek())) ++position_;
}

void TexReader::fail(std::size_t column, const std::string& what) const {
  throw core::usageError(fmt::format("column {} of \"{}\": {}", column, core::printable(tex_), what));
}

TexReader::Nested::Nested(TexReader& reader) : reader_(reader) {
  if (reader_.depth_ == kDeepest)
    reader_.fail(reader_.column(), fmt::format("nested more than {} deep", kDeepest));
  ++reader_.depth_;
}

}  // namespace poinsot::text
