// SPDX-License-Identifier: Apache-2.0
#include "figure/tex.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::figure {
namespace {

TEST(FigureTex, KeepsCommandsThatLatexKnows) {
  for (const char* tex :
       {R"($\boldsymbol{\omega}$)", R"($\hat{\mathbf{e}}_1 = \frac{L}{I_1}$)", R"(100\,\% \& \textbf{more})"})
    EXPECT_EQ(latexOf(tex), tex);
}

TEST(FigureTex, KeepsTheSignsThatSeparateElementsOfAMatrix) {
  for (const char* tex : {R"($I = \begin{bmatrix} 1 & -2 \\ 0 & \frac{a}{b} \end{bmatrix}$)"})
    EXPECT_EQ(latexOf(tex), tex);
  EXPECT_EQ(latexOf(R"($\begin{bmatrix} a & {b&c} \end{bmatrix}$ & d)"),
            R"($\begin{bmatrix} a & {b\&c} \end{bmatrix}$ \& d)");
}

// Expected by hand, from LaTeX's treatment of these signs: % begins a comment, # and & are errors in running text,
// < is an inverted exclamation mark in the old text font.
TEST(FigureTex, EscapesSpecialCharactersOfLatex) {
  EXPECT_EQ(latexOf("50% & #1"), R"(50\% \& \#1)");
  EXPECT_EQ(latexOf(R"(50\%)"), R"(50\%)");
  EXPECT_EQ(latexOf("$a<b$"), R"($a\ensuremath{<}b$)");
}

TEST(FigureTex, WritesCharactersAsCommands) {
  EXPECT_EQ(latexOf("$ω−θ̇$"), R"($\ensuremath{\omega}\ensuremath{-}\ensuremath{\dot{\theta}}$)");
  EXPECT_EQ(latexOf("Kreisel für Anfänger"), "Kreisel für Anfänger");
}

// siunitx makes \degree an error outside its \unit.
TEST(FigureTex, WritesDegreesWithoutACommandOfPackages) {
  EXPECT_EQ(latexOf("90°"), R"(90{\ensuremath{^{\circ}}})");
  EXPECT_EQ(latexOf(R"(5\degree C, $30\degree$)"), R"(5{\ensuremath{^{\circ}}}C, $30{\ensuremath{^{\circ}}}$)");
  EXPECT_EQ(latexOf(R"($x^\degree$)"), R"($x^{\ensuremath{^{\circ}}}$)");
}

// These characters are active in babel's German and Spanish, among others.
TEST(FigureTex, ProtectsCharactersThatBabelMakesActive) {
  EXPECT_EQ(latexOf(R"("a" und $"$)"), R"({\char34}a{\char34} und ${\char34}$)");
  EXPECT_EQ(latexOf("3~n"), R"(3\nobreakspace{}n)");
}

// The accent commands are those of source2e, "Font encodings", and of The TeXbook, chapter 16. pdflatex has no
// other way to write a letter that is not in T1.
TEST(FigureTex, WritesAccentCommandsForLettersLatexLacks) {
  EXPECT_EQ(latexOf("ẋ Ẍ ǐ ế ḥ"), R"(\.{x} \"{X} \v{\i} \'{\^{e}} \d{h})");
  EXPECT_EQ(latexOf("$ẋ \\mathrm{é} \\text{é ẋ} ǐ ḥ$"),
            R"($\dot{x} \mathrm{\acute{e}} \text{é \.{x}} \check{\imath} \text{\d{\ensuremath{h}}}$)");
  EXPECT_EQ(latexOf("v\u20D7 ή"), R"(\ensuremath{\vec{\text{v}}} \ensuremath{\acute{\eta}})");
  EXPECT_EQ(latexOf("ả"), "ả");  // LaTeX has the hook above in an encoding for Vietnamese only
}

TEST(FigureTex, WritesTheSameForDecomposedText) {
  for (const auto& [composed, decomposed] : {std::pair{"Größe Übung é", "Gro\u0308ße U\u0308bung e\u0301"},
                                             {"ẋ ế", "x\u0307 e\u0302\u0301"},
                                             {"$ẋ$", "$x\u0307$"}})
    EXPECT_EQ(latexOf(composed), latexOf(decomposed));
}

// LaTeX ends an optional argument at the first "]" outside braces.
TEST(FigureTex, KeepsTheIndexOfARoot) {
  EXPECT_EQ(latexOf(R"($\sqrt[3]{x}$ [1])"), R"($\sqrt[3]{x}$ [1])");
  EXPECT_EQ(latexOf(R"($\sqrt[\sqrt[3]{2}]{x}$)"), R"($\sqrt[{\sqrt[3]{2}}]{x}$)");
  EXPECT_EQ(latexOf(R"($\sqrt[{\sqrt[3]{2}}]{x}$)"), R"($\sqrt[{\sqrt[3]{2}}]{x}$)");
}

TEST(FigureTex, DefinesCommandsThatLatexLacks) {
  EXPECT_EQ(latexDefinitionsFor(R"($\omega$)"), "");
  EXPECT_EQ(latexDefinitionsFor(R"($\varkappa$)"), "\\providecommand*\\varkappa{\\kappa}%\n");
  EXPECT_EQ(latexDefinitionsFor(R"(\\varkappa)"), "");  // a line break and a word
  EXPECT_EQ(latexDefinitionsFor(R"($\Nu \Mu$)"),
            "\\providecommand*\\Mu{\\mathrm{M}}%\n\\providecommand*\\Nu{\\mathrm{N}}%\n");
}

TEST(FigureTex, RejectsUnknownCommands) {
  EXPECT_THROW(latexOf(R"(\input{/etc/passwd})"), core::Error);
  EXPECT_THROW(latexOf(R"($\write18{ls}$)"), core::Error);
}

}  // namespace
}  // namespace poinsot::figure
