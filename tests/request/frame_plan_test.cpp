// SPDX-License-Identifier: Apache-2.0
#include "request/frame_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::request {
namespace {

using ::testing::HasSubstr;

std::string refusalOf(const char* frames) {
  try {
    parseFrameRange(frames);
    return "taken";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.what();
  }
}

TEST(FramePlan, ReadsRanges) {
  EXPECT_EQ(parseFrameRange("0-59"), (FrameRange{0, 59}));
  EXPECT_EQ(parseFrameRange("120-120"), (FrameRange{120, 120}));
  EXPECT_EQ(parseFrameRange("7"), (FrameRange{7, 7}));
  for (const char* bad :
       {"", "-", "5-", "-5", "a-b", "1-2-3", "1 - 2", "1.5-2", "+1-2", "0x1-2", "1--2", "99999999999999999999-1"})
    EXPECT_THAT(refusalOf(bad), HasSubstr("': frames are A-B, both included")) << bad;
  EXPECT_EQ(refusalOf("9-3"), "--frames '9-3': the first frame, 9, comes after the last, 3");
}

TEST(FramePlan, SelectsAllFramesOrTheRequestedRange) {
  EXPECT_EQ(selectFrames(300, std::nullopt), (FrameRange{0, 299}));
  EXPECT_EQ(selectFrames(300, FrameRange{299, 299}), (FrameRange{299, 299}));
  try {
    selectFrames(300, FrameRange{290, 300});
    FAIL() << "frame 300 of 0 to 299";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    EXPECT_STREQ(error.what(), "--frames 290-300: the film has frames 0 to 299");
  }
}

TEST(FramePlan, CutsSegmentsAtMultiplesOf30) {
  EXPECT_EQ(segmentsOf({0, 74}), (std::vector<FrameRange>{{0, 29}, {30, 59}, {60, 74}}));
  EXPECT_EQ(segmentsOf({0, 29}), (std::vector<FrameRange>{{0, 29}}));
  EXPECT_EQ(segmentsOf({60, 60}), (std::vector<FrameRange>{{60, 60}}));
  EXPECT_EQ(segmentsOf({29, 61}), (std::vector<FrameRange>{{29, 29}, {30, 59}, {60, 61}}));
}

}  // namespace
}  // namespace poinsot::request
