// SPDX-License-Identifier: Apache-2.0
#include "output/figure_tex.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::output {
namespace {

TEST(FigureTex, PassesWhatLatexKnows) {
  for (const char* tex :
       {R"($\boldsymbol{\omega}$)", R"($\hat{\mathbf{e}}_1 = \frac{L}{I_1}$)", R"(100\,\% \& \textbf{more})"})
    EXPECT_EQ(latexOf(tex), tex);
}

// By hand, from what LaTeX does with these signs: % begins a comment, # and & are errors in running text, < is an
// inverted exclamation mark in the old text font.
TEST(FigureTex, ProtectsWhatLatexWouldReadOtherwise) {
  EXPECT_EQ(latexOf("50% & #1"), R"(50\% \& \#1)");
  EXPECT_EQ(latexOf(R"(50\%)"), R"(50\%)");
  EXPECT_EQ(latexOf("$a<b$"), R"($a\ensuremath{<}b$)");
}

TEST(FigureTex, SpellsCharactersByTheirCommands) {
  EXPECT_EQ(latexOf("$ω−θ̇$"), "$\\ensuremath{\\omega}\\ensuremath{-}\\ensuremath{\\theta}\u0307$");
  EXPECT_EQ(latexOf("90°"), R"(90\ensuremath{\degree})");
  EXPECT_EQ(latexOf("Kreisel für Anfänger"), "Kreisel für Anfänger");
}

TEST(FigureTex, DefinesWhatLatexLacks) {
  EXPECT_EQ(latexDefinitionsFor(R"($\omega$)"), "");
  EXPECT_EQ(latexDefinitionsFor(R"(90\degree)"), "\\providecommand*\\degree{\\ensuremath{^{\\circ}}}%\n");
  EXPECT_EQ(latexDefinitionsFor(R"(\\degree)"), "");  // a line break and a word
  EXPECT_EQ(latexDefinitionsFor(R"($\Nu \Mu$)"),
            "\\providecommand*\\Mu{\\mathrm{M}}%\n\\providecommand*\\Nu{\\mathrm{N}}%\n");
}

TEST(FigureTex, LetsNoOtherCommandThrough) {
  EXPECT_THROW(latexOf(R"(\input{/etc/passwd})"), core::Error);
  EXPECT_THROW(latexOf(R"($\write18{ls}$)"), core::Error);
}

}  // namespace
}  // namespace poinsot::output
