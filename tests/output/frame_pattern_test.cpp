// SPDX-License-Identifier: Apache-2.0
#include "output/frame_pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::output {
namespace {

TEST(FramePattern, NumbersFrames) {
  EXPECT_EQ(FramePattern("out/a_{frame:05}.png").path(7), "out/a_00007.png");
  EXPECT_EQ(FramePattern("out/a_{frame:05}.png").path(1234567), "out/a_1234567.png");
  EXPECT_EQ(FramePattern("{frame}.png").path(0), "0.png");
  EXPECT_EQ(FramePattern("a{frame:01}b.png").path(42), "a42b.png");
  EXPECT_EQ(FramePattern("{frame:09}").path(3), "000000003");
  EXPECT_THROW(FramePattern("{frame}.png").path(-1), std::logic_error);
}

TEST(FramePattern, ReadsTheFrameNumberFromAName) {
  const FramePattern pattern("out/a_{frame:03}.png");
  for (const std::int64_t k : {0, 7, 999, 1000, 1234567})
    EXPECT_EQ(pattern.frameOf(pattern.path(k).filename()), k);
  for (const char* name : {"a_7.png", "a_0007.png", "a_-07.png", "a_.png", "a_007.pngx", "b_007.png", "a_00x.png",
                           "a_99999999999999999999.png", "a_007", ""})
    EXPECT_EQ(pattern.frameOf(name), std::nullopt) << name;
}

TEST(FramePattern, IsDistinguishedFromAPlainName) {
  EXPECT_TRUE(FramePattern::isPattern("a_{frame}.png"));
  EXPECT_TRUE(FramePattern::isPattern("a_}.png"));  // a malformed pattern, not a plain name
  EXPECT_FALSE(FramePattern::isPattern("a_%05d.png"));
}

TEST(FramePattern, RejectsMalformedPatterns) {
  for (const char* text : {"a.png", "{}.png", "{Frame}.png", "{frame:5}.png", "{frame:00}.png", "{frame:010}.png",
                           "{frame:0x}.png", "{frame:}.png", "{frame", "frame}", "}frame{", "{{frame}}.png",
                           "{frame}_{frame}.png", "{frame}/a.png", "{frame}}.png", "{frame:-5}.png"})
    try {
      const FramePattern pattern{std::string(text)};
      ADD_FAILURE() << text << " was taken";
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      EXPECT_THAT(error.what(), ::testing::HasSubstr("name_{frame:05}.png")) << text;
    }
}

}  // namespace
}  // namespace poinsot::output
