// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "text/glyph_run.h"

namespace poinsot::text {

/// Typesets one line of text, written in UTF-8 in a small subset of TeX.
///
/// Outside formulas, text is upright and kerned. ' is an apostrophe, ``...'' are quotes, -- and --- are dashes, ~
/// is a non-breaking space. Commands: \textbf{...}, the spaces \, \; \quad and "\ ", and the characters \$ \% \&
/// \# \_ \{ \} \degree \ldots.
///
/// Inside $...$, Latin letters are italic and digits upright. Greek letters are commands (\omega, \Omega) or the
/// letters themselves. Alphabets: \mathbf \boldsymbol \mathrm \mathit. Accents: \hat \dot \ddot \bar \vec \tilde.
/// Scripts: _ ^ '. Also \frac{}{}, \dfrac{}{} with parts in full size, \sqrt{} \sqrt[3]{}, matrices as in
/// \begin{bmatrix} a & b \\ c & d \end{bmatrix}, \text{...}, functions (\sin) and the operators of commands.cpp,
/// spaced as in TeX. - is the minus sign.
///
/// Canonically equal texts, such as composed and decomposed letters, give the same result.
///
/// Examples: Poinsot's construction | $\boldsymbol{\omega}$ | $\hat{\mathbf{e}}_1$ | $2T/L$
/// @throws core::Error(kUsage) with the column (in characters, from 1): unknown command ("did you mean"), braces
/// or dollars that do not match, a missing argument, a character that the fonts lack.
GlyphRun setTex(std::string_view tex);

}  // namespace poinsot::text
