// SPDX-License-Identifier: Apache-2.0
#include "core/text.h"

#include <gtest/gtest.h>

#include <array>

namespace poinsot::core {
namespace {

// Expected distances are worked by hand.
TEST(EditDistance, CountsSingleEdits) {
  EXPECT_EQ(editDistance("omega", "omega"), 0);
  EXPECT_EQ(editDistance("omega", "omga"), 1);
  EXPECT_EQ(editDistance("moega", "omega"), 1);  // a swap of neighbours is one edit
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(Closest, SuggestsOnlySimilarWords) {
  const std::vector<std::string> keys = {"duration", "fps", "speed", "start"};
  EXPECT_EQ(closest("durration", keys), "duration");
  EXPECT_EQ(closest("sped", keys), "speed");
  EXPECT_EQ(closest("zzz", keys), std::nullopt);
  EXPECT_EQ(closest("fsp", keys), "fps");
  EXPECT_EQ(closest("tital", {"size", "title"}), "title");
  EXPECT_EQ(closest("z", {"1", "2", "3"}), std::nullopt);  // every letter would be replaced
}

TEST(Closest, FindsAWordByAPartOfIt) {
  const std::vector<std::string> keys = {"principal_moments", "omega_body"};
  EXPECT_EQ(closest("moments", keys), "principal_moments");
  EXPECT_EQ(closest("omega", keys), "omega_body");
  EXPECT_EQ(closest("mid", {"smallest", "middle"}), "middle");
  EXPECT_EQ(closest("om", keys), std::nullopt);
  EXPECT_EQ(closest("gravitation", {"spin", "gravity"}), "gravity");
  EXPECT_EQ(closest("grav-field", {"spin", "gravity"}), std::nullopt);
}

TEST(Printable, EscapesTerminalControlCharacters) {
  EXPECT_EQ(printable("plain ω text"), "plain ω text");
  EXPECT_EQ(printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(printable("a\nb\rc\x7f"), "a\\x0ab\\x0dc\\x7f");
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\u{202e}");        // right-to-left override
  EXPECT_EQ(printable("\xc2\x9b"), "\\x9b");                // C1 control sequence introducer
  EXPECT_EQ(printable("\xff\xc0\x80"), "\\xff\\xc0\\x80");  // not UTF-8, and an overlong NUL
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate half
}

TEST(SmallLettersHint, SuggestsTheNameWithALowerCaseEnding) {
  const std::vector<std::string> endings{".png", ".mp4"};
  EXPECT_EQ(smallLettersHint("out/A.MP4", endings), "; write the ending in lower case: out/A.mp4");
  EXPECT_EQ(smallLettersHint("a.b.Png", endings), "; write the ending in lower case: a.b.png");
  for (const char* name : {"a.mp4", "a.AVI", "aMP4", "", ".", "a.MP4.x"})
    EXPECT_EQ(smallLettersHint(name, endings), "") << name;
}

TEST(Lowered, ChangesAsciiCapitalsOnly) {
  EXPECT_EQ(lowered("@AZ[`az{ .STL"), "@az[`az{ .stl");
  EXPECT_EQ(lowered("Ångström ΩΩ"), "Ångström ΩΩ");
  EXPECT_EQ(lowered(""), "");
}

TEST(Printable, KeepsNewlinesAndTabsInLines) {
  EXPECT_EQ(printableLines("a\n\tω\r\n\x1b[2J\xff"), "a\n\tω\\x0d\n\\x1b[2J\\xff");
  EXPECT_EQ(printableLines(std::string(1000, 'x')), std::string(1000, 'x'));
  EXPECT_EQ(printableLines(""), "");
}

// Byte sequences from the Unicode standard, table 3-7.
TEST(FirstCodePoint, DecodesUtf8AndRejectsInvalidBytes) {
  EXPECT_EQ(firstCodePoint("ab").value, U'a');
  EXPECT_EQ(firstCodePoint("ωx").value, U'ω');
  EXPECT_EQ(firstCodePoint("\xf0\x9d\x91\x80").value, U'\U0001D440');
  EXPECT_EQ(firstCodePoint("\xf0\x9d\x91\x80").length, 4u);
  for (const char* bad : {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x88"})
    EXPECT_EQ(firstCodePoint(bad).length, 0u);
}

TEST(Printable, CutsAt200Characters) {
  EXPECT_EQ(printable(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(printable(std::string(201, 'x')), std::string(200, 'x') + "…");
}

TEST(Joined, HasSeparatorsBetweenWordsOnly) {
  EXPECT_EQ(joined(std::vector<std::string>{"a", "", "b"}, ", "), "a, , b");
  EXPECT_EQ(joined(std::array{std::string_view("a")}, ", "), "a");
  EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
}

}  // namespace
}  // namespace poinsot::core
