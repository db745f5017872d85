// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// Returns the extra space between two upright letters in text, in em; negative brings them closer. Latin Modern
/// Math is made for single letters and has no kerning, without which a title such as "Tennis" falls apart. Plain
/// letters use a table of letter shapes in the three steps of 1/36, 1/12 and 1/9 em that are usual for this
/// design. Accented letters have less room under an arm, so they use the kerning of Latin Modern Roman.
double kerning_em(char32_t left, char32_t right, bool bold);

}  // namespace poinsot::text
