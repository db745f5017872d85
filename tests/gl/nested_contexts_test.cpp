// SPDX-License-Identifier: Apache-2.0
// Several contexts of poinsot's at once: on one thread, which of them is current; on two threads, back ends whose
// functions differ. expectDraws() draws a triangle with the current context and reads it back.
#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <tuple>

#include "core/error.h"
#include "gl/drawing_check.h"
#include "gl/offscreen_context.h"
#include "support/back_ends.h"

namespace poinsot::gl {
namespace {

/// Expects that this one is current, and draws.
void expectCurrent(const OffscreenContext& context) {
  EXPECT_TRUE(context.isCurrent());
  EXPECT_NO_THROW(expectDraws());
  EXPECT_NE(context.version(), "");
}

/// Two back ends: of the outer context and of the inner one.
class NestedContextsTest : public testing::TestWithParam<std::tuple<Backend, Backend>> {
 protected:
  static void SetUpTestSuite() { pinEnvironment(true); }

  std::unique_ptr<OffscreenContext> outer_ = openContext(std::get<0>(GetParam()));
  std::unique_ptr<OffscreenContext> inner_ = openContext(std::get<1>(GetParam()));
};

TEST_P(NestedContextsTest, MakeTheOuterOneCurrentAgain) {
  EXPECT_FALSE(outer_->isCurrent());
  expectCurrent(*inner_);
  inner_.reset();
  expectCurrent(*outer_);
}

TEST_P(NestedContextsTest, LeaveTheInnerOneCurrentWhenTheOuterEndsFirst) {
  outer_.reset();
  expectCurrent(*inner_);
}

TEST_P(NestedContextsTest, SkipOneThatHasEnded) {
  auto innermost = openContext(Backend::kEgl);
  inner_.reset();
  expectCurrent(*innermost);
  innermost.reset();
  expectCurrent(*outer_);
}

TEST_P(NestedContextsTest, TakeTurns) {
  for (int turn = 0; turn < 2; ++turn) {
    outer_->makeCurrent();
    EXPECT_FALSE(inner_->isCurrent());
    expectCurrent(*outer_);
    inner_->makeCurrent();
    EXPECT_FALSE(outer_->isCurrent());
    expectCurrent(*inner_);
  }
  outer_->makeCurrent();
  inner_.reset();
  expectCurrent(*outer_);
}

TEST_P(NestedContextsTest, AreNotCurrentOnAnotherThread) {
  std::thread([&] {
    EXPECT_FALSE(inner_->isCurrent());
    expectCurrent(*openContext(std::get<0>(GetParam())));
    EXPECT_FALSE(inner_->isCurrent());
  }).join();
  expectCurrent(*inner_);
}

INSTANTIATE_TEST_SUITE_P(Of, NestedContextsTest,
                         testing::Combine(testing::ValuesIn(backEnds()), testing::ValuesIn(backEnds())),
                         [](const auto& backends) {
                           return testName(std::get<1>(backends.param)) + "Within" +
                                  testName(std::get<0>(backends.param));
                         });

// EGL's functions and OSMesa's differ: the table of one thread must not reach the other.
TEST(TwoThreads, DrawWithABackEndEach) {
  POINSOT_NEEDS_OSMESA();
  pinEnvironment(true);
  const auto drawWith = [](Backend backend) {
    for (int round = 0; round < 5; ++round) {
      const auto context = openContext(backend);
      for (int picture = 0; picture < 5; ++picture) EXPECT_NO_THROW(expectDraws());
    }
  };
  std::thread other(drawWith, Backend::kEgl);
  drawWith(Backend::kOsMesa);
  other.join();
}

}  // namespace
}  // namespace poinsot::gl
