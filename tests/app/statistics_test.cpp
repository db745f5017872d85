// SPDX-License-Identifier: Apache-2.0
#include "app/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poinsot::app {
namespace {

using ::testing::HasSubstr;

TEST(Statistics, AddUp) {
  Statistics sum{10, {1, 2, 3, 4}, 5, 6, 22, 100};
  sum += {30, {10, 20, 30, 40}, 50, 60, 220, 200};
  EXPECT_EQ(sum.frames, 40);
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
  // 100 frames; by hand 0.2 s / 100 = 2 ms; the rest 3.0 - (0.2 + 0.8 + 0.1 + 0.1 + 0.3 + 1.0) = 0.5 s = 5 ms.
  const std::string text = statisticsText({100, {0.2, 0.8, 0.1, 0.1}, 0.3, 1.0, 3.0, 64.0 * 1024 * 1024}, 2, 2.0);
  EXPECT_THAT(text, HasSubstr("100 frames in 2.00 s with 2 workers: 50.0 frames/s\n"));
  EXPECT_THAT(text, HasSubstr("  simulate + compose       2.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  render                   8.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  encode + write          10.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  start and other          5.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  in all                  30.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("64 MiB in 2 workers\n"));
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
