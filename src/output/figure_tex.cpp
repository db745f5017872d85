// SPDX-License-Identifier: Apache-2.0
#include "output/figure_tex.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"
#include "text/commands.h"
#include "text/math_setter.h"

namespace poinsot::output {
namespace {

/// The command that draws this character and nothing else.
const text::Command* commandFor(char32_t character) {
  const auto all = text::commands();
  const auto found = std::ranges::find_if(all, [&](const text::Command& c) {
    const bool drawn = c.kind == text::CommandKind::kSymbol || c.kind == text::CommandKind::kLetter;
    return drawn && c.character == character;
  });
  return found == all.end() ? nullptr : &*found;
}

std::string latexOf(char32_t character, std::string_view bytes) {
  if (character == U'%' || character == U'#' || character == U'&') return "\\" + std::string(bytes);
  // Signs of mathematics, which the old text fonts have other characters for.
  if (character == U'<' || character == U'>' || character == U'|') return fmt::format("\\ensuremath{{{}}}", bytes);
  if (character < 0x80) return std::string(bytes);
  if (character == U'−') return "\\ensuremath{-}";
  if (character == U'·') return "\\ensuremath{\\cdot}";
  const text::Command* command = commandFor(character);
  return command ? fmt::format("\\ensuremath{{\\{}}}", command->name) : std::string(bytes);
}

struct Definition {
  const char* name;
  const char* meaning;
};

// Greek letters that look like Latin ones have no command in LaTeX, and a few signs live in other packages.
constexpr Definition kDefinitions[] = {
    {"degree", "\\ensuremath{^{\\circ}}"},
    {"varkappa", "\\kappa"},
    {"omicron", "o"},
    {"Alpha", "\\mathrm{A}"},
    {"Beta", "\\mathrm{B}"},
    {"Epsilon", "\\mathrm{E}"},
    {"Zeta", "\\mathrm{Z}"},
    {"Eta", "\\mathrm{H}"},
    {"Iota", "\\mathrm{I}"},
    {"Kappa", "\\mathrm{K}"},
    {"Mu", "\\mathrm{M}"},
    {"Nu", "\\mathrm{N}"},
    {"Omicron", "\\mathrm{O}"},
    {"Rho", "\\mathrm{P}"},
    {"Tau", "\\mathrm{T}"},
    {"Chi", "\\mathrm{X}"},
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
  text::setTex(tex);  // or it throws
  std::string latex;
  while (!tex.empty()) {
    std::size_t length = core::firstCodePoint(tex).length;
    if (tex.front() == '\\') {
      length = 1 + core::firstCodePoint(tex.substr(1)).length;
      latex += tex.substr(0, length);
    } else {
      latex += latexOf(core::firstCodePoint(tex).value, tex.substr(0, length));
    }
    tex.remove_prefix(length);
  }
  return latex;
}

std::string latexDefinitionsFor(std::string_view latex) {
  std::string definitions;
  for (const Definition& d : kDefinitions)
    if (names(latex, d.name)) definitions += fmt::format("\\providecommand*\\{}{{{}}}%\n", d.name, d.meaning);
  return definitions;
}

}  // namespace poinsot::output
