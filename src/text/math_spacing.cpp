// SPDX-License-Identifier: Apache-2.0
#include "text/math_spacing.h"

namespace poinsot::text {
namespace {

// Rows left, columns right, both in the order of AtomClass. 1 thin, 2 medium, 3 thick; lower case letters t m k
// are the same spaces left out in scripts. "*" cannot occur: such a binary has become ordinary.
constexpr char kSpaces[8][9] = {
    "01mk000t",  // ordinary
    "11*k000t",  // function
    "mm**m**m",  // binary
    "kk*0k00k",  // relation
    "00*00000",  // opening
    "01mk000t",  // closing
    "tt*ttttt",  // punctuation
    "t1mkt0tt",  // inner
};

double mu(double count) { return count / 18; }

}  // namespace

double spaceBetween_em(AtomClass left, AtomClass right, bool inScript) {
  switch (kSpaces[static_cast<int>(left)][static_cast<int>(right)]) {
    case '1':
      return mu(3);
    case 't':
      return inScript ? 0 : mu(3);
    case 'm':
      return inScript ? 0 : mu(4);
    case 'k':
      return inScript ? 0 : mu(5);
    default:
      return 0;
  }
}

bool isSign(const AtomClass* left, const AtomClass* right) {
  if (left == nullptr || right == nullptr) return true;
  const bool afterOperator = *left == AtomClass::kBinary || *left == AtomClass::kRelation ||
                             *left == AtomClass::kOpening || *left == AtomClass::kPunctuation ||
                             *left == AtomClass::kFunction;
  const bool beforeEnd =
      *right == AtomClass::kRelation || *right == AtomClass::kClosing || *right == AtomClass::kPunctuation;
  return afterOperator || beforeEnd;
}

}  // namespace poinsot::text
