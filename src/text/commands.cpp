// SPDX-License-Identifier: Apache-2.0
#include "text/commands.h"

#include <algorithm>
#include <vector>

#include "core/text.h"

namespace poinsot::text {
namespace {

using enum AtomClass;

constexpr Command symbol(std::string_view name, char32_t character, AtomClass atomClass, bool inText = false) {
  return {.name = name,
          .kind = CommandKind::kSymbol,
          .character = character,
          .atomClass = atomClass,
          .inText = inText};
}
constexpr Command letter(std::string_view name, char32_t character) {
  return {.name = name, .kind = CommandKind::kLetter, .character = character};
}
constexpr Command accent(std::string_view name, char32_t combining) {
  return {.name = name, .kind = CommandKind::kAccent, .character = combining};
}
constexpr Command space(std::string_view name, double width_em) {
  return {.name = name, .kind = CommandKind::kSpace, .width_em = width_em, .inText = true};
}
constexpr Command function(std::string_view name) {
  return {.name = name, .kind = CommandKind::kFunction, .atomClass = kFunction};
}
constexpr Command alphabet(std::string_view name, Alphabet which) {
  return {.name = name, .kind = CommandKind::kAlphabet, .alphabet = which};
}
constexpr Command text(std::string_view name, Alphabet which) {
  return {.name = name, .kind = CommandKind::kText, .alphabet = which, .inText = true};
}

constexpr Command kCommands[] = {
    // Greek letters. \epsilon and \phi have the shapes of TeX; \varepsilon and \varphi have the other shapes.
    letter("alpha", U'α'),
    letter("beta", U'β'),
    letter("gamma", U'γ'),
    letter("delta", U'δ'),
    letter("epsilon", U'ϵ'),
    letter("varepsilon", U'ε'),
    letter("zeta", U'ζ'),
    letter("eta", U'η'),
    letter("theta", U'θ'),
    letter("vartheta", U'ϑ'),
    letter("iota", U'ι'),
    letter("kappa", U'κ'),
    letter("varkappa", U'ϰ'),
    letter("lambda", U'λ'),
    letter("mu", U'μ'),
    letter("nu", U'ν'),
    letter("xi", U'ξ'),
    letter("omicron", U'ο'),
    letter("pi", U'π'),
    letter("varpi", U'ϖ'),
    letter("rho", U'ρ'),
    letter("varrho", U'ϱ'),
    letter("sigma", U'σ'),
    letter("varsigma", U'ς'),
    letter("tau", U'τ'),
    letter("upsilon", U'υ'),
    letter("phi", U'ϕ'),
    letter("varphi", U'φ'),
    letter("chi", U'χ'),
    letter("psi", U'ψ'),
    letter("omega", U'ω'),
    letter("Alpha", U'Α'),
    letter("Beta", U'Β'),
    letter("Gamma", U'Γ'),
    letter("Delta", U'Δ'),
    letter("Epsilon", U'Ε'),
    letter("Zeta", U'Ζ'),
    letter("Eta", U'Η'),
    letter("Theta", U'Θ'),
    letter("Iota", U'Ι'),
    letter("Kappa", U'Κ'),
    letter("Lambda", U'Λ'),
    letter("Mu", U'Μ'),
    letter("Nu", U'Ν'),
    letter("Xi", U'Ξ'),
    letter("Omicron", U'Ο'),
    letter("Pi", U'Π'),
    letter("Rho", U'Ρ'),
    letter("Sigma", U'Σ'),
    letter("Tau", U'Τ'),
    letter("Upsilon", U'Υ'),
    letter("Phi", U'Φ'),
    letter("Chi", U'Χ'),
    letter("Psi", U'Ψ'),
    letter("Omega", U'Ω'),
    letter("partial", U'∂'),
    alphabet("mathrm", Alphabet::kRoman),
    alphabet("mathit", Alphabet::kMathItalic),
    alphabet("mathbf", Alphabet::kBold),
    alphabet("boldsymbol", Alphabet::kBoldItalic),
    text("text", Alphabet::kRoman),
    text("textbf", Alphabet::kBold),
    // Accents. They are combining characters, whose glyphs lie to the left of their origin.
    accent("hat", U'\u0302'),
    accent("dot", U'\u0307'),
    accent("ddot", U'\u0308'),
    accent("bar", U'\u0304'),
    accent("vec", U'\u20D7'),
    accent("tilde", U'\u0303'),
    // Spaces. Widths are in eighteenths of an em. The word space has the width that the font gives it.
    space(",", 3.0 / 18),
    space(":", 4.0 / 18),
    space(";", 5.0 / 18),
    space("!", -3.0 / 18),
    space(" ", 1.0 / 3),
    space("quad", 1),
    space("qquad", 2),
    {.name = "frac", .kind = CommandKind::kFraction, .atomClass = kInner},
    {.name = "dfrac", .kind = CommandKind::kDisplayFraction, .atomClass = kInner},
    {.name = "sqrt", .kind = CommandKind::kRoot},
    {.name = "begin", .kind = CommandKind::kMatrix, .atomClass = kInner},
    symbol("times", U'×', kBinary),
    symbol("cdot", U'⋅', kBinary),
    symbol("pm", U'±', kBinary),
    symbol("mp", U'∓', kBinary),
    symbol("circ", U'∘', kBinary),
    symbol("approx", U'≈', kRelation),
    symbol("sim", U'∼', kRelation),
    symbol("simeq", U'≃', kRelation),
    symbol("equiv", U'≡', kRelation),
    symbol("propto", U'∝', kRelation),
    symbol("ne", U'≠', kRelation),
    symbol("neq", U'≠', kRelation),
    symbol("le", U'≤', kRelation),
    symbol("leq", U'≤', kRelation),
    symbol("ge", U'≥', kRelation),
    symbol("geq", U'≥', kRelation),
    symbol("ll", U'≪', kRelation),
    symbol("gg", U'≫', kRelation),
    symbol("in", U'∈', kRelation),
    symbol("to", U'→', kRelation),
    symbol("rightarrow", U'→', kRelation),
    symbol("leftarrow", U'←', kRelation),
    symbol("Rightarrow", U'⇒', kRelation),
    symbol("mapsto", U'↦', kRelation),
    symbol("perp", U'⟂', kRelation),
    symbol("parallel", U'∥', kRelation),
    symbol("infty", U'∞', kOrdinary),
    symbol("degree", U'°', kOrdinary, true),
    symbol("nabla", U'∇', kOrdinary),
    symbol("ell", U'ℓ', kOrdinary),
    symbol("hbar", U'ℏ', kOrdinary),
    symbol("prime", U'′', kOrdinary),
    symbol("ldots", U'…', kInner, true),
    symbol("cdots", U'⋯', kInner),
    symbol("langle", U'⟨', kOpening),
    symbol("rangle", U'⟩', kClosing),
    symbol("|", U'‖', kOrdinary),
    // Commands for characters that have a special meaning in TeX, such as $.
    symbol("$", U'$', kOrdinary, true),
    symbol("%", U'%', kOrdinary, true),
    symbol("&", U'&', kOrdinary, true),
    symbol("#", U'#', kOrdinary, true),
    symbol("_", U'_', kOrdinary, true),
    symbol("{", U'{', kOpening, true),
    symbol("}", U'}', kClosing, true),
    function("sin"),
    function("cos"),
    function("tan"),
    function("cot"),
    function("arccos"),
    function("arcsin"),
    function("arctan"),
    function("sinh"),
    function("cosh"),
    function("tanh"),
    function("exp"),
    function("ln"),
    function("log"),
    function("min"),
    function("max"),
    function("det"),
};

constexpr Symbol kTyped[][2] = {
    {{U'-'}, {U'−', kBinary}},      {{U'*'}, {U'∗', kBinary}},   {{U'+'}, {U'+', kBinary}},
    {{U'−'}, {U'−', kBinary}},      {{U'·'}, {U'⋅', kBinary}},   {{U'='}, {U'=', kRelation}},
    {{U'<'}, {U'<', kRelation}},    {{U'>'}, {U'>', kRelation}}, {{U':'}, {U':', kRelation}},
    {{U'('}, {U'(', kOpening}},     {{U'['}, {U'[', kOpening}},  {{U')'}, {U')', kClosing}},
    {{U']'}, {U']', kClosing}},     {{U'!'}, {U'!', kClosing}},  {{U','}, {U',', kPunctuation}},
    {{U';'}, {U';', kPunctuation}},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* findCommand(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &Command::name);
  return found == std::end(kCommands) ? nullptr : &*found;
}

std::string nearestCommand(std::string_view name) {
  std::vector<std::string> names;
  for (const Command& command : kCommands) names.emplace_back(command.name);
  return core::closest(name, names).value_or("");
}

Symbol symbolOf(char32_t typed) {
  for (const auto& [from, to] : kTyped)
    if (from.character == typed) return to;
  for (const Command& command : kCommands)
    if (command.kind == CommandKind::kSymbol && command.character == typed) return {typed, command.atomClass};
  return {typed, kOrdinary};
}

}  // namespace poinsot::text
