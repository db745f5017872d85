// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "text/canonical.h"
#include "text/commands.h"
#include "text/math_layout.h"
#include "text/parsers.h"

namespace poinsot::text {
namespace {

MathStyle raised(const MathStyle& style) { return {std::min(style.level + 1, 2), style.cramped, style.alphabet}; }
MathStyle upright(const MathStyle& style) { return {style.level, style.cramped, Alphabet::kRoman}; }
MathStyle cramped(const MathStyle& style) { return {style.level, true, style.alphabet}; }

constexpr std::u32string_view kRowEnd = U"\\\\", kMatrixEnd = U"\\end{bmatrix}";

class MathParser {
 public:
  MathParser(TexReader& reader, const MathStyle& style) : reader_(reader), style_(style) {}

  Box parseList(const ListEnd& end) {
    const TexReader::Nested nested(reader_);
    std::vector<Atom> atoms;
    while (reader_.skipBlanks(), !takeEnd(reader_, end)) parseItem(atoms);
    return joined(atoms, style_);
  }

  // Parses one letter, one command with its arguments, or one group in braces, with the marks that follow.
  Atom parseNucleus() {
    const TexReader::Nested nested(reader_);
    const std::size_t column = reader_.column();
    const char32_t c = reader_.take();
    if (c == U'$') reader_.fail(column, "'$' inside braces; close them first");
    if (c != U'\\' && c != U'{') return letterAtom(takeLetter(reader_, c, style_.alphabet));
    Atom atom = c == U'\\' ? parseCommand(column) : Atom{parseMath(reader_, style_, {U'}', column})};
    while (isMark(reader_.peek())) {
      for (const char32_t mark : takeLetter(reader_, reader_.take(), style_.alphabet))
        atom.box = accented(atom.box, mark, style_);
    }
    return atom;
  }

 private:
  static bool isScriptSign(char32_t c) { return c == U'_' || c == U'^' || c == U'\''; }

  void parseItem(std::vector<Atom>& atoms) {
    if (isScriptSign(reader_.peek()))
      atoms.push_back({});  // empty base, as in {}^2
    else
      atoms.push_back(parseNucleus());
    parseScripts(atoms.back());
  }

  Atom letterAtom(std::u32string_view glyphs) const {
    const Symbol symbol = symbolOf(glyphs.front());
    Atom atom{glyphBox(symbol.character, style_), symbol.atomClass};
    for (const char32_t mark : glyphs.substr(1)) atom.box = accented(atom.box, mark, style_);
    return atom;
  }

  void parseScripts(Atom& atom) {
    Scripts scripts;
    bool any = false;
    for (reader_.skipBlanks(); isScriptSign(reader_.peek()); reader_.skipBlanks()) {
      any = true;
      parseScript(scripts);
    }
    if (any) atom.box = withScripts(atom.box, scripts, style_);
  }

  void parseScript(Scripts& scripts) {
    const std::size_t column = reader_.column();
    const char32_t sign = reader_.take();
    if (sign == U'\'') {
      if (!scripts.primes) scripts.primes.emplace();
      append(*scripts.primes, glyphBox(U'′', style_));
      return;
    }
    std::optional<Box>& script = sign == U'_' ? scripts.sub : scripts.sup;
    if (script) reader_.fail(column, fmt::format("a second '{}'; put both in braces", static_cast<char>(sign)));
    const MathStyle style = raised(style_);
    script =
        parseArgument(column, fmt::format("'{}'", static_cast<char>(sign)), sign == U'_' ? cramped(style) : style);
  }

  // Parses the argument of a script or a command: a group in braces, or a single item.
  Box parseArgument(std::size_t column, const std::string& what, const MathStyle& style) {
    reader_.skipBlanks();
    const char32_t next = reader_.peek();
    if (reader_.atEnd() || next == U'}' || next == U'$' || isScriptSign(next))
      reader_.fail(column, what + " needs an argument, such as {x}");
    return MathParser(reader_, style).parseNucleus().box;
  }

  Atom parseCommand(std::size_t column) {
    const std::string name = reader_.takeName();
    const Command* command = findCommand(name);
    if (command == nullptr) failUnknownCommand(reader_, column, name);
    const std::string what = "\\" + name;
    switch (command->kind) {
      case CommandKind::kSymbol:
      case CommandKind::kLetter:
        return {glyphBox(command->character, style_), command->atomClass};
      case CommandKind::kSpace:
        return {spaceBox(command->width_em, style_.level), {}, true};
      case CommandKind::kFunction:
        return {functionBox(name), AtomClass::kFunction};
      case CommandKind::kText:
        return {runningText(*command, column)};
      case CommandKind::kAlphabet:
        return {parseArgument(column, what, {style_.level, style_.cramped, command->alphabet})};
      case CommandKind::kAccent:
        return {accented(parseArgument(column, what, cramped(style_)), command->character, upright(style_))};
      case CommandKind::kRoot:
        return {rootBox(column, what)};
      case CommandKind::kFraction:
        return {fractionBox(column, what, raised(style_), false), AtomClass::kInner};
      case CommandKind::kMatrix:
        return {matrixBox(column), AtomClass::kInner};
      case CommandKind::kDisplayFraction:
        break;
    }
    return {fractionBox(column, what, style_, true), AtomClass::kInner};
  }

  Box fractionBox(std::size_t column, const std::string& what, const MathStyle& parts, bool display) {
    const Box numerator = parseArgument(column, what, parts);
    const Box denominator = parseArgument(column, what, cramped(parts));
    return fraction(numerator, denominator, style_, display);
  }

  // Parses a matrix after \begin.
  Box matrixBox(std::size_t column) {
    if (!reader_.takeIf(U"{bmatrix}"))
      reader_.fail(column, "\\begin begins a matrix: \\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}");
    std::vector<std::vector<Box>> rows(1);
    while (rows.back().push_back(cellBox(column)), !reader_.takeIf(kMatrixEnd))
      if (!reader_.takeIf(U'&')) reader_.takeIf(kRowEnd), rows.emplace_back();
    const std::vector<Box>& last = rows.back();
    if (rows.size() > 1 && last.size() == 1 && last[0].glyphs.empty()) rows.pop_back();  // the last row has an end
    return bracketedMatrix(rows, style_);
  }

  Box cellBox(std::size_t column) {
    const TexReader::Nested nested(reader_);
    std::vector<Atom> atoms;
    while (reader_.skipBlanks(), !isAtCellEnd(column)) parseItem(atoms);
    return joined(atoms, style_);
  }

  bool isAtCellEnd(std::size_t column) const {
    if (reader_.atEnd() || reader_.peek() == U'$' || reader_.peek() == U'}')
      reader_.fail(column, "this matrix is never closed; write \\end{bmatrix} after its last row");
    return reader_.peek() == U'&' || reader_.isAt(kRowEnd) || reader_.isAt(kMatrixEnd);
  }

  Box functionBox(const std::string& name) const {
    return textBox(std::u32string(name.begin(), name.end()), false, style_.level);
  }

  Box runningText(const Command& command, std::size_t column) {
    if (!reader_.takeIf(U'{')) reader_.fail(column, fmt::format("\\{0} needs braces: \\{0}{{...}}", command.name));
    const TextStyle text{command.alphabet == Alphabet::kBold, style_.level, true};
    return parseText(reader_, text, {U'}', reader_.column() - 1});
  }

  Box rootBox(std::size_t column, const std::string& what) {
    const std::optional<Box> index = rootIndex();
    const auto root = squareRoot(parseArgument(column, what, cramped(style_)), style_);
    if (!root) reader_.fail(column, "the expression under the root is taller than the font's largest root sign");
    return index ? withIndex(*root, *index, style_) : *root;
  }

  // Parses the index of a root, such as the 3 of \sqrt[3]{x}. An index has the smallest text size.
  std::optional<Box> rootIndex() {
    const std::size_t column = reader_.column();
    if (!reader_.takeIf(U'[')) return std::nullopt;
    Box index = parseMath(reader_, {2, style_.cramped, style_.alphabet}, {U']', column});
    if (index.glyphs.empty()) reader_.fail(column, "a root with an empty index; write \\sqrt{x}, or \\sqrt[3]{x}");
    return index;
  }

  TexReader& reader_;
  MathStyle style_;
};

}  // namespace

Box parseMath(TexReader& reader, const MathStyle& style, const ListEnd& end) {
  return MathParser(reader, style).parseList(end);
}

}  // namespace poinsot::text
