// SPDX-License-Identifier: Apache-2.0
#include "core/interruption.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

#include "core/step_times.h"

namespace poinsot::core {
namespace {

void loop(double seconds) {
  const std::int64_t end_ns = monotonic_ns() + static_cast<std::int64_t>(1e9 * seconds);
  while (monotonic_ns() < end_ns) checkInterruption();
}

TEST(Interruption, CallsTheCheckEveryFiftyMilliseconds) {
  int calls = 0;
  const InterruptionCheck check([&] { ++calls; });
  loop(0.02);
  EXPECT_EQ(calls, 0);
  loop(0.2);  // 4 calls on an idle machine
  EXPECT_GE(calls, 1);
  EXPECT_LE(calls, 4);
}

TEST(Interruption, PropagatesExceptionsOfTheCheck) {
  const InterruptionCheck check([] { throw std::runtime_error("stop"); });
  usleep(60'000);
  EXPECT_THROW(checkInterruption(), std::runtime_error);
}

TEST(Interruption, AppliesOnlyToItsThreadAndScope) {
  int outer = 0, inner = 0;
  const InterruptionCheck check([&] { ++outer; });
  {
    const InterruptionCheck nested([&] { ++inner; });
    usleep(60'000);
    checkInterruption();
    std::jthread([] { checkInterruption(); }).join();
  }
  EXPECT_EQ(inner, 1);
  EXPECT_EQ(outer, 0);
  checkInterruption();
  EXPECT_EQ(outer, 1);
}

}  // namespace
}  // namespace poinsot::core
