// SPDX-License-Identifier: Apache-2.0
#include "core/shell_word.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/hostile_words.h"
#include "support/shell_run.h"

namespace poinsot::core {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ShellWord, RoundTripsThroughBash) {
  for (const std::string& word : kHostileWords) {
    const std::string written = shellWord(word);
    EXPECT_EQ(runShell("/", "x=" + written + "; printf '%s.' \"$x\" " + written).out, word + "." + word + ".")
        << written;
    EXPECT_THAT(written, Not(HasSubstr("\n")));
  }
}

TEST(ShellWord, LeavesPlainWordsUnquoted) {
  EXPECT_EQ(shellWord("out/film_1-2.mp4"), "out/film_1-2.mp4");
  EXPECT_EQ(shellWords({"-D", "time.fps=30", "a b"}), "-D time.fps=30 'a b'");
}

}  // namespace
}  // namespace poinsot::core
