// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "text/glyph_run.h"

namespace poinsot::text {

/// Sets one line written in a small subset of TeX, in UTF-8.
///
/// Outside formulas: upright roman text, kerned; ' is an apostrophe, ``...'' are quotes, -- and --- dashes, ~ a
/// space; \textbf{...}, \, \; \quad and "\ " spaces, \$ \% \& \# \_ \{ \} \degree \ldots. Inside $...$: Latin
/// letters italic, digits upright, Greek by command (\omega, \Omega) or as the letter itself, \mathbf \boldsymbol
/// \mathrm \mathit, accents \hat \dot \ddot \bar \vec \tilde, scripts _ ^ ', \frac{}{}, \dfrac{}{} with its parts
/// in full size, \sqrt{} \sqrt[3]{}, \text{...}, functions (\sin) and the operators of commands.cpp, spaced as in
/// TeX; - is the minus sign.
///
/// Canonically equal texts, such as composed and decomposed letters, are set the same.
///
/// Examples: Poinsot's construction | $\boldsymbol{\omega}$ | $\hat{\mathbf{e}}_1$ | $2T/L$
/// @throws core::Error(kUsage) with the column (in characters, from 1): unknown command ("did you mean"), braces
/// or dollars that do not match, a missing argument, a character that the fonts lack.
GlyphRun setTex(std::string_view tex);

}  // namespace poinsot::text
