// SPDX-License-Identifier: Apache-2.0
#include "app/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poinsot::app {
namespace {

using ::testing::HasSubstr;

TEST(Statistics, AddUp) {
  Statistics sum{10, 1, 0.5, {1, 2, 3, 4}, 5, 6, 22, 100};
  sum += {30, 1, 0.25, {10, 20, 30, 40}, 50, 60, 220, 200};
  EXPECT_EQ(sum.frames, 40);
  EXPECT_EQ(sum.workers, 2);
  EXPECT_EQ(sum.first_s, 0.75);
  EXPECT_EQ(sum.making.compose_s, 11);
  EXPECT_EQ(sum.making.render_s, 22);
  EXPECT_EQ(sum.making.read_s, 33);
  EXPECT_EQ(sum.making.text_s, 44);
  EXPECT_EQ(sum.convert_s, 55);
  EXPECT_EQ(sum.encode_s, 66);
  EXPECT_EQ(sum.cpu_s, 242);
  EXPECT_EQ(sum.peakMemory_bytes, 300);
}

TEST(Statistics, TextIsPerFrame) {
  // 102 frames, 100 of which are no worker's first. By hand: 0.2 s / 100 = 2 ms, 1.02 s / 102 = 10 ms, and what is
  // left, 5.1 - (0.2 + 0.8 + 0.1 + 0.1 + 0.3 + 1.02 + 2.0) = 0.58 s, is 290 ms for each of two workers.
  const std::string text =
      statisticsText({102, 2, 2.0, {0.2, 0.8, 0.1, 0.1}, 0.3, 1.02, 5.1, 64.0 * 1024 * 1024}, 2.0);
  EXPECT_THAT(text, HasSubstr("102 frames in 2.00 s with 2 workers: 51.0 frames/s\n"));
  EXPECT_THAT(text, HasSubstr("  simulate + compose       2.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  render                   8.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  encode + write          10.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  first frame           1000.00 ms CPU per worker, shaders compiled\n"));
  EXPECT_THAT(text, HasSubstr("  start and other        290.00 ms CPU per worker\n"));
  EXPECT_THAT(text, HasSubstr("  in all                  50.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  peak memory             64.00 MiB, workers together\n"));
}

TEST(Statistics, ClocksRun) {
  const double before_s = processCpu_s();
  volatile double sink = 0;
  while (processCpu_s() - before_s < 1e-3) sink = sink + 1;
  EXPECT_GT(sink, 0);
  EXPECT_GT(processPeakMemory_bytes(), 1e6);
}

}  // namespace
}  // namespace poinsot::app
