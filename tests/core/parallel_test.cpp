// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/interruption.h"

namespace poinsot::core {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

TEST(ForEachIndex, ThrowsTheErrorOfTheLowestIndex) {
  const auto work = [](std::size_t i) {
    if (i == 0) std::this_thread::sleep_for(20ms);  // the other fails first
    throw std::runtime_error(std::to_string(i));
  };
  for (const int jobs : {1, 2}) {
    try {
      forEachIndex(2, jobs, work);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0") << jobs;
    }
  }
}

TEST(ForEachIndex, EndsAllWorkWhenItsCallerIsInterrupted) {
  for (const int jobs : {1, 3}) {
    std::atomic<int> ended = 0;
    const auto work = [&](std::size_t) {
      const auto end = Clock::now() + 10s;
      try {
        while (Clock::now() < end) checkInterruption();
      } catch (...) {
        ++ended;
        throw;
      }
    };
    const InterruptionCheck check([] { throw std::runtime_error("stop"); });
    const auto begin = Clock::now();
    EXPECT_THROW(forEachIndex(100, jobs, work), std::runtime_error);
    EXPECT_LT(Clock::now() - begin, 1s) << jobs;  // takes 0.15 s
    EXPECT_EQ(ended, jobs);
  }
}

}  // namespace
}  // namespace poinsot::core
