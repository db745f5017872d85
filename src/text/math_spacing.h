// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::text {

/// What part a piece of a formula plays; the space around it follows.
enum class AtomClass { kOrdinary, kFunction, kBinary, kRelation, kOpening, kClosing, kPunctuation, kInner };

/// Space between two neighbours in em of the current size: thin 3/18, medium 4/18 (around + - ×), thick 5/18
/// (around = < →). In scripts only functions keep theirs. Source: D. E. Knuth, The TeXbook, chapter 18, the table
/// of atom spacing.
double spaceBetween_em(AtomClass left, AtomClass right, bool inScript);

/// Whether a binary operator between these two is only a sign (as in "-1", "= -x"): then it is ordinary.
bool isSign(const AtomClass* left, const AtomClass* right);

}  // namespace poinsot::text
