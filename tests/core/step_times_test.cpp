// SPDX-License-Identifier: Apache-2.0
#include "core/step_times.h"

#include <gtest/gtest.h>

namespace poinsot::core {
namespace {

void work(double seconds) {
  volatile double sink = 0;
  for (const double before_s = processCpu_s(); processCpu_s() - before_s < seconds;) sink = sink + 1;
}

TEST(StepTimes, SubtractsInnerStepsFromTheOuterStep) {
  StepLedger steps;
  {
    const StepScope outer(&steps, Step::kEncode);
    work(1e-3);
    const StepScope inner(&steps, Step::kWrite);
    work(4e-3);
  }
  const auto& times = steps.times();
  EXPECT_GT(times[Step::kEncode], 0.5e-3);
  EXPECT_GT(times[Step::kWrite], 3.5e-3);
  EXPECT_LT(times[Step::kEncode], times[Step::kWrite]);
  EXPECT_EQ(times.sum_s(), times[Step::kEncode] + times[Step::kWrite]);
  EXPECT_TRUE(steps.takeSpans().empty());  // tracing is off
}

TEST(StepTimes, ScopeDoesNothingWithoutALedger) { const StepScope scope(nullptr, Step::kDraw); }

TEST(StepTimes, MergesSpansOfARepeatedInnerStep) {
  StepLedger steps;
  steps.trace();
  steps.setFrame(7);
  {
    const StepScope outer(&steps, Step::kCompose);
    for (int i = 0; i < 3; ++i) {
      const StepScope inner(&steps, Step::kSimulate);
      work(1e-4);
    }
  }
  const auto spans = steps.takeSpans();
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].name, "simulate");
  EXPECT_EQ(spans[1].name, "compose");
  EXPECT_EQ(spans[0].frame, 7);
  EXPECT_GE(spans[0].begin_ns, spans[1].begin_ns);
  EXPECT_LE(spans[0].end_ns, spans[1].end_ns);
  EXPECT_GE(spans[0].end_ns - spans[0].begin_ns, 300'000);
  EXPECT_TRUE(steps.takeSpans().empty());
}

TEST(StepTimes, SeparatesSpansOfDifferentFrames) {
  StepLedger steps;
  steps.trace();
  for (int k = 0; k < 2; ++k) {
    steps.setFrame(k);
    const StepScope scope(&steps, Step::kDraw);
  }
  EXPECT_EQ(steps.takeSpans().size(), 2u);
}

}  // namespace
}  // namespace poinsot::core
