// SPDX-License-Identifier: Apache-2.0
#include "text/kerning.h"

#include <string_view>

#include "text/font.h"

namespace poinsot::text {
namespace {

constexpr double kSlight_em = -1.0 / 36;
constexpr double kClear_em = -1.0 / 12;
constexpr double kDeep_em = -1.0 / 9;

// Extra space between any letter of `left` and any letter of `right` that follows it.
struct Pair {
  std::u32string_view left;
  std::u32string_view right;
  double amount_em;
};

constexpr Pair kPairs[] = {
    // Letter with an overhanging arm, followed by a low letter.
    {U"T", U"aceoqruwy", kClear_em},
    {U"T", U"A", kClear_em},
    {U"FVW", U"aeoru", kClear_em},
    {U"FVW", U"A", kDeep_em},
    {U"VW", U"CGOQ", kSlight_em},
    {U"Y", U"aeoru", kClear_em},
    {U"Y", U"A", kClear_em},
    {U"P", U"A", kClear_em},
    {U"P", U"aeo", kSlight_em},
    {U"FPTVWYvwyr", U".,", kClear_em},
    {U"FTVWY", U"-–—:;", kSlight_em},
    // Slanted side next to a slanted side, or foot below an arm.
    {U"AR", U"CGOQUt", kSlight_em},
    {U"A", U"TY", kClear_em},
    {U"A", U"VW", kDeep_em},
    {U"A", U"vwy’", kSlight_em},
    {U"R", U"TVWY", kSlight_em},
    {U"L", U"TY’", kClear_em},
    {U"L", U"VW", kDeep_em},
    {U"L", U"y", kSlight_em},
    {U"DO", U"AVWXY", kSlight_em},
    {U"KX", U"CGOQ", kSlight_em},
    {U"kvwy", U"aceo", kSlight_em},
    {U"a", U"vwy", kSlight_em},
    {U"hmn", U"tuvwy", kSlight_em},
    {U"bop", U"vwxy", kSlight_em},
    {U"c", U"hk", kSlight_em},
    // Round letters that would touch, and an f before a tall character: more space.
    {U"bop", U"ceoq", -kSlight_em},
    {U"f", U"’?!)]", -kClear_em},
};

// Reports whether a letter is Latin with an accent, or Greek. Such letters are not in kPairs, whose other
// characters beyond ASCII are punctuation from U+2000 on.
bool isAccented(char32_t character) { return character >= U'\u00C0' && character < U'\u2000'; }

}  // namespace

double kerning_em(char32_t left, char32_t right, bool bold) {
  if (isAccented(left) || isAccented(right))
    return Font::of(bold ? Typeface::kBold : Typeface::kRoman).kerning_em(left, right);
  for (const Pair& pair : kPairs)
    if (pair.left.find(left) != pair.left.npos && pair.right.find(right) != pair.right.npos) return pair.amount_em;
  return 0;
}

}  // namespace poinsot::text
