// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// Returns the extra space between two upright letters of text in em; negative values bring them closer. Latin
/// Modern Math is made for single letters and has no kerning table, without which words such as "Tennis" look
/// uneven. Plain letters therefore use a table of pairs with the amounts 1/36, 1/12 and 1/9 em, which are usual
/// for this design. Accented letters have less room under an arm and use Latin Modern Roman's kerning.
double kerning_em(char32_t left, char32_t right, bool bold);

}  // namespace poinsot::text
