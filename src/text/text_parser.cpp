// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"
#include "text/canonical.h"
#include "text/commands.h"
#include "text/letter_glyph.h"
#include "text/parsers.h"
#include "text/plain_text.h"

namespace poinsot::text {
namespace {

// Sequence that is typed for a character that keyboards do not have, such as -- for an en dash. Longest first.
struct Typed {
  std::u32string_view typed;
  char32_t character;
};
constexpr Typed kTypography[] = {{U"---", U'—'}, {U"--", U'–'}, {U"``", U'“'},    {U"''", U'”'},
                                 {U"`", U'‘'},   {U"'", U'’'},  {U"~", U'\u00A0'}};

std::u32string withTypography(std::u32string_view text) {
  std::u32string result;
  while (!text.empty()) {
    char32_t character = text.front();
    std::size_t length = 1;
    for (const Typed& t : kTypography) {
      if (!text.starts_with(t.typed)) continue;
      character = t.character;
      length = t.typed.size();
      break;
    }
    result += character;
    text.remove_prefix(length);
  }
  return result;
}

// Returns a hint on how to write a character that has a special meaning, such as \$ for $.
std::string orTheSign(char sign) {
  const std::string name(1, sign);
  return findCommand(name) ? fmt::format("for the character itself write \\{}", name)
                           : "there is no command for the character itself";
}

class TextParser {
 public:
  TextParser(TexReader& reader, const TextStyle& style) : reader_(reader), style_(style) {}

  Box parse(const ListEnd& end) {
    const TexReader::Nested nested(reader_);
    while (!takeEnd(reader_, end)) parseNext();
    setPending();
    return std::move(line_);
  }

 private:
  void parseNext() {
    const std::size_t column = reader_.column();
    const char32_t c = reader_.take();
    if (c == U'\\') return parseCommand(column);
    if (c == U'$') return parseFormula(column);
    if (c == U'{') return setBox(parseText(reader_, style_, {U'}', column}));
    if (c == U'_' || c == U'^') failScript(column, static_cast<char>(c));
    if (isBlank(c)) {
      reader_.skipBlanks();
      pending_ += U' ';
      return;
    }
    pending_ += takeLetter(reader_, c, textAlphabet(style_.bold));
  }

  [[noreturn]] void failScript(std::size_t column, char sign) const {
    reader_.fail(column, fmt::format("'{0}' outside a formula; write $...{0}...$, such as $x{0}1$; {1}", sign,
                                     orTheSign(sign)));
  }

  void parseFormula(std::size_t column) {
    if (style_.insideMath) reader_.fail(column, "a formula inside \\text{...}; end the text first");
    setBox(parseMath(reader_, {style_.level, false, Alphabet::kMathItalic}, {U'$', column}));
  }

  void parseCommand(std::size_t column) {
    const std::string name = reader_.takeName();
    const Command* command = findCommand(name);
    if (command == nullptr) failUnknownCommand(reader_, column, name);
    if (!command->inText) reader_.fail(column, fmt::format("\\{0} outside a formula; write $\\{0}...$", name));
    switch (command->kind) {
      case CommandKind::kSpace:
        return setBox(spaceBox(command->width_em, style_.level));
      case CommandKind::kText:
        return parseArgument(*command, column);
      default:
        pending_ += command->character;  // symbol that is also allowed outside formulas
    }
  }

  void parseArgument(const Command& command, std::size_t column) {
    if (!reader_.takeIf(U'{')) reader_.fail(column, fmt::format("\\{0} needs braces: \\{0}{{...}}", command.name));
    TextStyle inner = style_;
    inner.bold = style_.bold || command.alphabet == Alphabet::kBold;
    setBox(parseText(reader_, inner, {U'}', reader_.column() - 1}));
  }

  void setBox(const Box& box) {
    setPending();
    append(line_, box);
  }

  // Typesets the pending text. Text is collected first, because kerning and ligatures depend on neighbours.
  void setPending() {
    if (!pending_.empty()) append(line_, textBox(withTypography(pending_), style_.bold, style_.level));
    pending_.clear();
  }

  TexReader& reader_;
  TextStyle style_;
  std::u32string pending_;
  Box line_;
};

}  // namespace

Box parseText(TexReader& reader, const TextStyle& style, const ListEnd& end) {
  Box box = TextParser(reader, style).parse(end);
  box.accentX = box.width / 2;
  return box;
}

namespace {

// Reports an opening sign that is never closed, at the end of the text or where an outer part ends.
void failUnclosed(const TexReader& reader, const ListEnd& end) {
  if (end.sign == U'}') reader.fail(end.openedAt, "'{' is never closed; " + orTheSign('{'));
  if (end.sign == U'$') reader.fail(end.openedAt, "'$' is never closed; a formula is $...$; " + orTheSign('$'));
  if (end.sign == U']') reader.fail(end.openedAt, "'[' is never closed; a root with an index is \\sqrt[3]{x}");
}

}  // namespace

bool takeEnd(TexReader& reader, const ListEnd& end) {
  if (reader.atEnd()) {
    failUnclosed(reader, end);
    return true;
  }
  if (end.sign != 0 && reader.takeIf(end.sign)) return true;
  const char32_t next = reader.peek();
  if (end.sign == U']' && (next == U'}' || next == U'$')) failUnclosed(reader, end);
  if (next == U'}') reader.fail(reader.column(), "'}' without its '{'; " + orTheSign('}'));
  return false;
}

void failUnknownCommand(const TexReader& reader, std::size_t column, const std::string& name) {
  const std::string meant = nearestCommand(name);
  const std::string hint = meant.empty() ? "" : fmt::format("; did you mean \\{}?", meant);
  reader.fail(column, fmt::format("unknown command \\{}{}", name, hint));
}

std::u32string takeLetter(TexReader& reader, char32_t letter, Alphabet alphabet) {
  const std::size_t column = reader.column() - 1;
  std::u32string typed(1, letter);
  while (isMark(reader.peek())) typed += reader.take();
  const std::u32string glyphs = splitIntoGlyphs(typed, alphabet);
  const auto lacks = [&](char32_t c) { return !glyphOf(c, alphabet); };
  if (std::ranges::none_of(glyphs, lacks)) return glyphs;
  // Finds the first of the typed characters that cannot be drawn alone, for the error message.
  const auto missing = std::ranges::find_if(typed, [&](char32_t c) {
    return std::ranges::any_of(splitIntoGlyphs({&c, 1}, alphabet), lacks);
  });
  const std::size_t at = missing == typed.end() ? 0 : static_cast<std::size_t>(missing - typed.begin());
  reader.fail(column + at,
              fmt::format("the font has no glyph for {} (U+{:04X})", core::printable(toUtf8({&typed[at], 1})),
                          static_cast<unsigned>(typed[at])));
}

}  // namespace poinsot::text
