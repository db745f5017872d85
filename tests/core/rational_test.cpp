// SPDX-License-Identifier: Apache-2.0
#include "core/rational.h"

#include <gtest/gtest.h>

namespace poinsot::core {
namespace {

TEST(Rational, ReadsIntegersFractionsAndDecimals) {
  EXPECT_EQ(parseRational("30"), (Rational{30, 1}));
  EXPECT_EQ(parseRational("30000/1001"), (Rational{30000, 1001}));
  EXPECT_EQ(parseRational("60/2"), (Rational{30, 1}));
  EXPECT_EQ(parseRational("29.97"), (Rational{2997, 100}));
  EXPECT_EQ(parseRational("12.5"), (Rational{25, 2}));
}

TEST(Rational, RejectsMalformedAndNonPositiveNumbers) {
  for (const char* text :
       {"",      "0",  "-30", "30/0",  "0/1",         "/",     "30/", "/2",  "1e3",  " 30",  "30 ",
        "30fps", "1.", ".5",  "1.2.3", "99999999999", "30/-1", "+30", "nan", "0x10", "1/2/3"})
    EXPECT_EQ(parseRational(text), std::nullopt) << text;
}

}  // namespace
}  // namespace poinsot::core
