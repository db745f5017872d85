// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "text/commands.h"
#include "text/coverage.h"
#include "text/math_setter.h"

namespace poinsot::text {
namespace {

std::string failureOf(const std::string& tex) {
  try {
    setTex(tex);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.message();
  }
  return "no error";
}

struct Mistake {
  const char* tex;
  int column;  // counted by hand, in characters
  const char* says;
};

std::string tower(int stories) {
  const std::string below = stories > 1 ? tower(stories - 1) : "a";
  return "\\frac{" + below + "}{" + below + "}";
}

TEST(TexError, NamesTheColumnAndTheCorrection) {
  const std::string tall = "$a\\sqrt{" + tower(4) + "}$";
  const Mistake kMistakes[] = {
      {"$\\omgea$", 2, "unknown command \\omgea; did you mean \\omega?"},
      {"a $\\mathbb{R}$", 4, "unknown command \\mathbb; did you mean \\mathbf?"},
      {"$\\zzzzzzzz$", 2, "unknown command \\zzzzzzzz"},
      {"ωω $x", 4, "'$' is never closed"},
      {"cost 5$", 7, "'$' is never closed; a formula is $...$; for the character itself write \\$"},
      {"$\\mathbf{L$", 11, "'$' inside braces"},
      {"$\\mathbf{L", 9, "'{' is never closed"},
      {"\\textbf{a", 8, "'{' is never closed"},
      {"ab}", 3, "'}' without its '{'"},
      {"$a}$", 3, "'}' without its '{'"},
      {"x_1", 2, "'_' outside a formula; write $..._...$"},
      {"\\omega", 1, "\\omega outside a formula; write $\\omega...$"},
      {"$x_$", 3, "'_' needs an argument"},
      {"$x^{2}^3$", 7, "a second '^'; put both in braces"},
      {"$x_1_2$", 5, "a second '_'"},
      {"$\\hat$", 2, "\\hat needs an argument"},
      {"$\\frac{1}$", 2, "\\frac needs an argument"},
      {tall.c_str(), 3, "the expression under the root is taller than the font's largest root sign"},
      {"$\\sqrt[3{x}$", 7, "'[' is never closed; a root with an index is \\sqrt[3]{x}"},
      {"$a+\\sqrt[{3]}{x}$", 9, "'[' is never closed"},
      {"${\\sqrt[3}]{x}$", 8, "'[' is never closed"},
      {"$\\sqrt[3", 7, "'[' is never closed"},
      {"$\\sqrt[3]$", 2, "\\sqrt needs an argument"},
      {"$\\sqrt[]{x}$", 7, "a root with an empty index; write \\sqrt{x}, or \\sqrt[3]{x}"},
      {"L^2", 2,
       "'^' outside a formula; write $...^...$, such as $x^1$; there is no command for the character itself"},
      {"\\textbf a", 1, "\\textbf needs braces: \\textbf{...}"},
      {"$\\text{a $b$}$", 10, "a formula inside \\text{...}"},
      {"L 漢", 3, "the font has no glyph for 漢 (U+6F22)"},
      {"$漢$", 2, "the font has no glyph for 漢 (U+6F22)"},
      {"ab\xff", 3, "not valid UTF-8"},
      {"ab\\", 3, "a backslash at the end"},
      {"$ab\\", 4, "a backslash at the end"},
      {"$\\ω$", 2, "a backslash before a character that is not a command"},
      {"$\\\x7f$", 2, "a backslash before a character that is not a command"},  // found by fuzzing
      {"a\x01", 2, "the font has no glyph for \\x01 (U+0001)"},
  };
  for (const Mistake& m : kMistakes) {
    const std::string message = failureOf(m.tex);
    EXPECT_THAT(message, ::testing::StartsWith("column " + std::to_string(m.column) + " of \"")) << m.tex;
    EXPECT_THAT(message, ::testing::HasSubstr(m.says)) << m.tex;
  }
}

// The commands for TeX's own characters are from The TeXbook, chapter 7. TeX has no command that draws ^, ~ or a
// backslash in running text.
TEST(TexError, NamesTheCommandOfASignOnlyIfItDrawsTheSign) {
  const std::string kSpecial = "&%#~{}\\$_^", kDrawn = "&%#{}$_";
  for (const char sign : kSpecial) {
    const std::string command = std::string("\\") + sign;
    const bool drawn = kDrawn.find(sign) != kDrawn.npos;
    EXPECT_EQ(failureOf(command) == "no error", drawn) << command;
    if (drawn) {
      EXPECT_EQ(setTex(command).plainText, std::string(1, sign));
    }
    for (const std::string& tex : {std::string(1, sign), "a" + std::string(1, sign) + "b",
                                   "$a" + std::string(1, sign) + "$", "a" + command}) {
      const std::string message = failureOf(tex);
      for (const char other : kSpecial) {
        const bool named = message.find(std::string("for the character itself write \\") + other) != message.npos;
        const bool right = kDrawn.find(other) != kDrawn.npos && tex.find(other) != tex.npos;
        EXPECT_TRUE(!named || right) << message;
      }
    }
  }
  for (const char sign : std::string("{}$_"))
    EXPECT_THAT(failureOf(std::string(1, sign)),
                ::testing::HasSubstr(std::string("for the character itself write \\") + sign));
  EXPECT_THAT(failureOf("^"), ::testing::HasSubstr("no command for the character"));
}

TEST(TexError, NamesTheFormOfAMatrix) {
  using ::testing::HasSubstr;
  EXPECT_THAT(failureOf("$\\begin{pmatrix} 1 \\end{pmatrix}$"), HasSubstr("column 2 of"));
  EXPECT_THAT(failureOf("$\\begin{pmatrix} 1 \\end{pmatrix}$"),
              HasSubstr("\\begin begins a matrix: \\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}"));
  EXPECT_THAT(failureOf("$\\begin{bmatrix} 1 & 2$"), HasSubstr("this matrix is never closed"));
  EXPECT_THAT(failureOf("$\\begin{bmatrix} 1 }$"), HasSubstr("this matrix is never closed"));
  EXPECT_THAT(failureOf("$1 \\end{bmatrix}$"), HasSubstr("unknown command \\end"));
  EXPECT_EQ(failureOf("$\\begin{bmatrix}\\end{bmatrix}$"), "no error");
  std::string nested = "$";
  for (int i = 0; i < 60; ++i) nested += "\\begin{bmatrix}";
  EXPECT_THAT(failureOf(nested), HasSubstr("nested more than 40 deep"));
}

TEST(TexError, LimitsHostileInput) {
  EXPECT_THAT(failureOf(std::string(2001, 'x')), ::testing::HasSubstr("too long; at most 2000 characters"));
  EXPECT_EQ(failureOf(std::string(2000, 'x')), "no error");
  EXPECT_THAT(failureOf("$" + std::string(900, '{')), ::testing::HasSubstr("nested more than 40 deep"));
  EXPECT_THAT(failureOf(std::string(900, '{')), ::testing::HasSubstr("nested more than 40 deep"));
  std::string roots = "$";
  for (int i = 0; i < 300; ++i) roots += "\\sqrt";
  EXPECT_THAT(failureOf(roots + "x$"), ::testing::HasSubstr("nested more than 40 deep"));
}

// The list is the documentation's (math_setter.h), not the table's, so that a command dropped from the table fails
// here.
TEST(Commands, EveryDocumentedCommandCanBeSet) {
  for (const char* name :
       {"alpha",    "beta",     "gamma",   "delta",  "epsilon", "varepsilon", "zeta",    "eta",   "theta",
        "vartheta", "iota",     "kappa",   "lambda", "mu",      "nu",         "xi",      "pi",    "rho",
        "sigma",    "tau",      "upsilon", "phi",    "varphi",  "chi",        "psi",     "omega", "Gamma",
        "Delta",    "Theta",    "Lambda",  "Xi",     "Pi",      "Sigma",      "Upsilon", "Phi",   "Psi",
        "Omega",    "times",    "cdot",    "pm",     "approx",  "le",         "ge",      "to",    "infty",
        "perp",     "parallel", "degree",  "sin",    "cos"})
    EXPECT_FALSE(setTex(std::string("$\\") + name + "$").glyphs.empty()) << name;
  for (const char* name :
       {"mathbf", "boldsymbol", "mathrm", "text", "textbf", "hat", "dot", "ddot", "bar", "vec", "tilde", "sqrt"})
    EXPECT_FALSE(setTex(std::string("$\\") + name + "{x}$").glyphs.empty()) << name;
  for (const char* name : {",", ";", " ", "quad"}) EXPECT_GT(setTex(std::string("$\\") + name + "$").width_em, 0);
}

/// Returns what must follow a command.
std::string argumentOf(const Command& command) {
  const CommandKind kind = command.kind;
  if (kind == CommandKind::kMatrix) return "{bmatrix} x & y \\end{bmatrix}";
  if (kind == CommandKind::kFraction || kind == CommandKind::kDisplayFraction) return "{x}{y}";
  return kind >= CommandKind::kAccent ? "{x}" : " ";
}

TEST(Commands, EveryCommandInTheTableHasItsGlyphAtEverySize) {
  for (const Command& c : commands()) {
    const std::string use = "\\" + std::string(c.name) + argumentOf(c);
    for (const std::string& tex :
         {"$" + use + "$", "$x_{" + use + "}$", "$\\mathbf{" + use + "}$", "$\\boldsymbol{" + use + "}$"})
      EXPECT_EQ(failureOf(tex), "no error") << tex;
    EXPECT_EQ(failureOf(use) == "no error", c.inText) << use;
  }
}

// Any bytes give success or core::Error(kUsage), and every number of a success is finite.
TEST(TexFuzz, AnyBytesAreSetOrRejected) {
  std::mt19937 random(20240515);
  const std::vector<std::string> kPieces = {"$",
                                            "$",
                                            "{",
                                            "}",
                                            "_",
                                            "^",
                                            "'",
                                            "\\",
                                            "\\frac",
                                            "\\sqrt",
                                            "\\hat",
                                            "\\mathbf",
                                            "\\boldsymbol",
                                            "\\omega",
                                            "\\text{",
                                            "\\textbf{",
                                            "\\,",
                                            "\\quad",
                                            "-",
                                            "+",
                                            "=",
                                            "x",
                                            "L",
                                            "1",
                                            " ",
                                            "ω",
                                            "é",
                                            "ẋ",
                                            "\u0301",
                                            "\u0323",
                                            "\\sqrt[",
                                            "]",
                                            "漢",
                                            "\xff",
                                            "fi",
                                            "AV",
                                            "(",
                                            ")",
                                            ",",
                                            "\\sin",
                                            "\\{",
                                            "\\degree",
                                            std::string(1, '\0'),
                                            "\n",
                                            "i",
                                            "\\nonsense"};
  int set = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string tex = random() % 2 == 0 ? "$" : "";
    for (unsigned i = random() % 12; i > 0; --i) tex += kPieces[random() % kPieces.size()];
    if (tex.starts_with("$")) tex += "$";
    try {
      const GlyphRun run = setTex(tex);
      ++set;
      ASSERT_TRUE(std::isfinite(run.width_em + run.ascent_em + run.descent_em)) << tex;
      ASSERT_LE(run.inkLeft_em, run.inkRight_em) << tex;
      if (round % 16 == 0) rasterize(run, 20, 3.3, 30.7, round % 32 == 0 ? 2 : 0);
    } catch (const core::Error& error) {
      ASSERT_EQ(error.kind(), core::ErrorKind::kUsage) << tex;
    }
  }
  EXPECT_GT(set, 2000);  // enough rounds are not refused at once
}

}  // namespace
}  // namespace poinsot::text
