// SPDX-License-Identifier: Apache-2.0
#include "figure/tex.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/text.h"
#include "text/canonical.h"
#include "text/commands.h"
#include "text/math_setter.h"
#include "text/plain_text.h"
#include "text/tex_reader.h"

namespace poinsot::figure {
namespace {

/// LaTeX commands for a mark on a letter, in running text and in formulas. Empty if there is no command.
struct Accent {
  char32_t mark;
  std::string_view text;
  std::string_view math;
};
constexpr Accent kAccents[] = {
    {U'\u0300', "`", "grave"},    {U'\u0301', "'", "acute"}, {U'\u0302', "^", "hat"},   {U'\u0303', "~", "tilde"},
    {U'\u0304', "=", "bar"},      {U'\u0306', "u", "breve"}, {U'\u0307', ".", "dot"},   {U'\u0308', "\"", "ddot"},
    {U'\u030A', "r", "mathring"}, {U'\u030B', "H", ""},      {U'\u030C', "v", "check"}, {U'\u0323', "d", ""},
    {U'\u0331', "b", ""},         {U'\u20D7', "", "vec"},
};

const Accent* accentOf(char32_t mark) {
  const auto* found = std::ranges::find(kAccents, mark, &Accent::mark);
  return found == std::end(kAccents) ? nullptr : found;
}

/// Returns the command that draws a character. Returns null if there is none.
const text::Command* commandFor(char32_t character) {
  const auto all = text::commands();
  const auto found = std::ranges::find_if(all, [&](const text::Command& c) {
    const bool drawn = c.kind == text::CommandKind::kSymbol || c.kind == text::CommandKind::kLetter;
    return drawn && c.character == character;
  });
  return found == all.end() ? nullptr : &*found;
}

/// Replacement for \degree. If a document loads the package siunitx, \degree is an error outside \unit.
constexpr std::string_view kDegree = "{\\ensuremath{^{\\circ}}}";

std::string latexOfCharacter(char32_t character) {
  const std::string bytes = text::toUtf8({&character, 1});
  if (character == U'%' || character == U'#' || character == U'&') return "\\" + bytes;
  // The package babel makes " a command in German and many other languages, and ~ in Spanish and Estonian.
  if (character == U'"') return "{\\char34}";
  if (character == U'~') return "\\nobreakspace{}";
  // Mathematical symbols. LaTeX's old text fonts have other characters at their codes.
  if (character == U'<' || character == U'>' || character == U'|') return fmt::format("\\ensuremath{{{}}}", bytes);
  if (character < 0x80) return bytes;
  if (character == U'−') return "\\ensuremath{-}";
  if (character == U'·') return "\\ensuremath{\\cdot}";
  if (character == U'°') return std::string(kDegree);
  const text::Command* command = commandFor(character);
  return command ? fmt::format("\\ensuremath{{\\{}}}", command->name) : bytes;
}

bool haveAccents(std::u32string_view marks) {
  return std::ranges::all_of(marks, [](char32_t mark) { return accentOf(mark) != nullptr; });
}

std::string accented(std::string base, std::u32string_view marks, bool inMath) {
  for (const char32_t mark : marks) {
    const Accent& accent = *accentOf(mark);
    const std::string_view own = inMath ? accent.math : accent.text;
    const std::string_view other = inMath ? accent.text : accent.math;
    if (!own.empty())
      base = fmt::format("\\{}{{{}}}", own, base);
    else if (inMath)
      base = fmt::format("\\text{{\\{}{{\\ensuremath{{{}}}}}}}", other, base);
    else
      base = fmt::format("\\ensuremath{{\\{}{{\\text{{{}}}}}}}", other, base);
  }
  return base;
}

/// Returns a letter as the argument of accent commands. Under a mark above, i and j have no dot.
std::string baseUnder(std::u32string_view marks, char32_t letter, bool inMath) {
  const bool dotted = letter == U'i' || letter == U'j';
  if (!dotted || text::placeOf(marks.front()) != text::MarkPlace::kAbove) return latexOfCharacter(letter);
  return fmt::format("\\{}{}", static_cast<char>(letter), inMath ? "math" : "");
}

/// Returns LaTeX for a letter and its marks. In running text, letters up to U+017F stay as they are, because LaTeX
/// has them in every encoding. Other letters, and all letters in formulas, are written with accent commands.
std::string latexOfLetter(std::u32string_view typed, bool inMath) {
  const std::u32string known = text::composed(typed, [&](char32_t c) { return !inMath && c < 0x180; });
  if (known.size() == 1) return latexOfCharacter(known.front());
  const std::u32string parts = text::decomposed(typed), marks = parts.substr(1);
  if (!haveAccents(marks)) return text::toUtf8(text::composed(typed, [](char32_t) { return true; }));
  if (const text::Command* greek = commandFor(parts.front()))
    return fmt::format("\\ensuremath{{{}}}", accented("\\" + std::string(greek->name), marks, true));
  return accented(baseUnder(marks, parts.front(), inMath), marks, inMath);
}

/// Converts the TeX of a label to LaTeX. The label must be valid for text::setTex().
class LatexWriter {
 public:
  explicit LatexWriter(std::string_view tex) {
    while (!tex.empty()) {
      const core::CodePoint next = core::firstCodePoint(tex);
      tex_ += next.value;
      tex.remove_prefix(next.length);
    }
  }

  std::string write() {
    while (at_ < tex_.size()) {
      if (peek() == U'\\')
        addCommand();
      else if (std::u32string_view(U"{}$]").find(peek()) != std::u32string_view::npos)
        addBracket(static_cast<char>(tex_[at_++]));
      else if (peek() == U'&' && isInCell())
        latex_ += static_cast<char>(tex_[at_++]);
      else
        addLetter();
    }
    return std::move(latex_);
  }

 private:
  /// Index of a root: its start in the output, its depth in braces, and whether it contains another index.
  struct Index {
    std::size_t begin;
    std::size_t depth;
    bool nested;
  };

  char32_t peek() const { return at_ < tex_.size() ? tex_[at_] : U'\0'; }

  void addLetter() {
    const std::size_t begin = at_++;
    const std::u32string marks = takeMarks();
    latex_ += latexOfLetter(tex_[begin] + marks, inMath_.back());
  }

  void addCommand() {
    ++at_;
    const std::string name = takeName();
    if (name == "degree") {
      latex_ += kDegree;
      skipBlanks();
      return;
    }
    const std::u32string marks = takeMarks();
    latex_ += haveAccents(marks) ? accented("\\" + name, marks, true) : "\\" + name + text::toUtf8(marks);
    textFollows_ = name == "text" || name == "textbf";
    if (name == "sqrt") addIndex();
    if (name == "begin") matrices_.push_back(inMath_.size());
    if (name == "end") matrices_.pop_back();
  }

  bool isInCell() const { return !matrices_.empty() && matrices_.back() == inMath_.size(); }

  std::string takeName() {
    const std::size_t begin = at_++;
    while (isLetter(tex_[begin]) && isLetter(peek())) ++at_;
    return text::toUtf8(std::u32string_view(tex_).substr(begin, at_ - begin));
  }

  std::u32string takeMarks() {
    const std::size_t begin = at_;
    while (at_ < tex_.size() && text::isMark(tex_[at_])) ++at_;
    return text::decomposed(std::u32string_view(tex_).substr(begin, at_ - begin));
  }

  void skipBlanks() {
    while (text::isBlank(peek())) ++at_;
  }

  void addIndex() {
    skipBlanks();
    if (peek() != U'[') return;
    ++at_;
    if (isInIndex()) indices_.back().nested = true;
    latex_ += '[';
    indices_.push_back({latex_.size(), inMath_.size(), false});
  }

  bool isInIndex() const { return !indices_.empty() && indices_.back().depth == inMath_.size(); }

  void addBracket(char bracket) {
    if (bracket == '{') inMath_.push_back(!textFollows_ && inMath_.back());
    if (bracket == '}') inMath_.pop_back();
    if (bracket == '$') inMath_.back() = !inMath_.back();
    if (bracket == ']' && isInIndex()) closeIndex();
    latex_ += bracket;
    textFollows_ = false;
  }

  /// Ends an index. An index that contains another index is put in braces, because LaTeX ends an index at the
  /// first "]" outside braces.
  void closeIndex() {
    if (indices_.back().nested) {
      latex_.insert(indices_.back().begin, 1, '{');
      latex_ += '}';
    }
    indices_.pop_back();
  }

  static bool isLetter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

  std::u32string tex_;
  std::size_t at_ = 0;
  std::string latex_;
  std::vector<bool> inMath_ = {false};
  bool textFollows_ = false;  // true after \text or \textbf, until its opening brace
  std::vector<Index> indices_;
  std::vector<std::size_t> matrices_;  // depth in braces of each open matrix
};

struct Definition {
  const char* name;
  const char* meaning;
};

// LaTeX has no commands for Greek letters that look like Latin letters.
constexpr Definition kDefinitions[] = {
    {"varkappa", "\\kappa"},    {"omicron", "o"},        {"Alpha", "\\mathrm{A}"}, {"Beta", "\\mathrm{B}"},
    {"Epsilon", "\\mathrm{E}"}, {"Zeta", "\\mathrm{Z}"}, {"Eta", "\\mathrm{H}"},   {"Iota", "\\mathrm{I}"},
    {"Kappa", "\\mathrm{K}"},   {"Mu", "\\mathrm{M}"},   {"Nu", "\\mathrm{N}"},    {"Omicron", "\\mathrm{O}"},
    {"Rho", "\\mathrm{P}"},     {"Tau", "\\mathrm{T}"},  {"Chi", "\\mathrm{X}"},
};

bool names(std::string_view latex, std::string_view command) {
  for (std::size_t at = latex.find('\\'); at != latex.npos; at = latex.find('\\', at + 2)) {
    if (latex.substr(at + 1, command.size()) != command) continue;
    const char next = latex.substr(at + 1 + command.size(), 1).empty() ? ' ' : latex[at + 1 + command.size()];
    if (!((next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z'))) return true;
  }
  return false;
}

}  // namespace

std::string latexOf(std::string_view tex) {
  text::setTex(tex);  // throws if the label is not valid
  return LatexWriter(tex).write();
}

std::string latexDefinitionsFor(std::string_view latex) {
  std::string definitions;
  for (const Definition& d : kDefinitions)
    if (names(latex, d.name)) definitions += fmt::format("\\providecommand*\\{}{{{}}}%\n", d.name, d.meaning);
  return definitions;
}

}  // namespace poinsot::figure
