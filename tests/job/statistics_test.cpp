// SPDX-License-Identifier: Apache-2.0
#include "job/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poinsot::job {
namespace {

using ::testing::HasSubstr;

using core::Step;

/// Returns 1, 2 ... 9 s times `factor`.
core::StepTimes rising(double factor) {
  core::StepTimes times;
  for (std::size_t i = 0; i < core::kSteps; ++i) times[static_cast<Step>(i)] = factor * static_cast<double>(i + 1);
  return times;
}

TEST(Statistics, AddUpOverAllWorkers) {
  Statistics sum{10, 1, 0.5, rising(1), 22, 100};
  sum += {30, 1, 0.25, rising(10), 220, 200};
  EXPECT_EQ(sum.frames, 40);
  EXPECT_EQ(sum.workers, 2);
  EXPECT_EQ(sum.first_s, 0.75);
  EXPECT_EQ(sum.steps[Step::kSimulate], 11);
  EXPECT_EQ(sum.steps[Step::kWrite], 99);
  EXPECT_EQ(sum.steps.sum_s(), 11 * 45);
  EXPECT_EQ(sum.cpu_s, 242);
  EXPECT_EQ(sum.peakMemory_bytes, 300);
}

TEST(Statistics, TextGivesCpuTimePerFrame) {
  // 102 frames, 100 of which are not a worker's first. By hand: 0.1 s / 100 = 1 ms, and 0.9 s * 1000 / 102 = 8.82
  // ms. The rest, 7.08 - (0.1 * 45 + 2.0) = 0.58 s, is 290 ms for each of two workers.
  const std::string text = statisticsText({102, 2, 2.0, rising(0.1), 7.08, 64.0 * 1024 * 1024}, 2.0);
  EXPECT_THAT(text, HasSubstr("102 frames in 2.00 s with 2 workers: 51.0 frames/s\n"));
  EXPECT_THAT(text, HasSubstr("  simulate                 1.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  compose                  2.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  draw                     3.00 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  write                    8.82 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  first frame           1000.00 ms CPU per worker, shaders compiled\n"));
  EXPECT_THAT(text, HasSubstr("  start and other        290.00 ms CPU per worker\n"));
  EXPECT_THAT(text, HasSubstr("  in all                  69.41 ms CPU per frame\n"));
  EXPECT_THAT(text, HasSubstr("  peak memory             64.00 MiB, workers together\n"));
}

TEST(Statistics, ReportsPeakMemory) { EXPECT_GT(processPeakMemory_bytes(), 1e6); }

}  // namespace
}  // namespace poinsot::job
