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

TEST(FramePattern, IsToldFromAPlainName) {
  EXPECT_TRUE(FramePattern::isPattern("a_{frame}.png"));
  EXPECT_TRUE(FramePattern::isPattern("a_}.png"));  // meant as one, and refused as one
  EXPECT_FALSE(FramePattern::isPattern("a_%05d.png"));
}

TEST(FramePattern, RefusesTheRest) {
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
