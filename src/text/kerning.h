// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// Extra space between two upright letters in text, in em (negative: closer). Latin Modern Math, made for single
/// letters, brings no kerning, and a title such as "Tennis" falls apart without: for plain letters this is a table
/// of letter shapes in the three steps of 1/36, 1/12 and 1/9 em usual for this design. Accented letters have less
/// room under an arm; their kerning is that of Latin Modern Roman.
double kerning_em(char32_t left, char32_t right, bool bold);

}  // namespace poinsot::text
