// SPDX-License-Identifier: Apache-2.0
// Several contexts of poinsot at once: which of them is current on one thread, and back ends with different
// functions on two threads. expectDraws() draws a triangle with the current context and reads it back.
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

void expectCurrent(const OffscreenContext& context) {
  EXPECT_TRUE(context.isCurrent());
  EXPECT_NO_THROW(expectDraws());
  EXPECT_NE(context.version(), "");
}

class NestedContextsTest : public testing::TestWithParam<std::tuple<Backend, Backend>> {
 protected:
  static void SetUpTestSuite() { pinEnvironment(true); }

  std::unique_ptr<OffscreenContext> outer_ = openContext(std::get<0>(GetParam()));
  std::unique_ptr<OffscreenContext> inner_ = openContext(std::get<1>(GetParam()));
};

TEST_P(NestedContextsTest, TheOuterContextIsRestoredWhenTheInnerEnds) {
  EXPECT_FALSE(outer_->isCurrent());
  expectCurrent(*inner_);
  inner_.reset();
  expectCurrent(*outer_);
}

TEST_P(NestedContextsTest, TheInnerContextStaysCurrentWhenTheOuterEnds) {
  outer_.reset();
  expectCurrent(*inner_);
}

TEST_P(NestedContextsTest, AContextThatHasEndedIsNotRestored) {
  auto innermost = openContext(Backend::kEgl);
  inner_.reset();
  expectCurrent(*innermost);
  innermost.reset();
  expectCurrent(*outer_);
}

TEST_P(NestedContextsTest, ContextsCanAlternate) {
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

TEST_P(NestedContextsTest, ContextsAreNotCurrentOnAnotherThread) {
  std::thread([&] {
    EXPECT_FALSE(inner_->isCurrent());
    expectCurrent(*openContext(std::get<0>(GetParam())));
    EXPECT_FALSE(inner_->isCurrent());
  }).join();
  expectCurrent(*inner_);
}

INSTANTIATE_TEST_SUITE_P(Each, NestedContextsTest,
                         testing::Combine(testing::ValuesIn(backEnds()), testing::ValuesIn(backEnds())),
                         [](const auto& backends) {
                           return testName(std::get<1>(backends.param)) + "Within" +
                                  testName(std::get<0>(backends.param));
                         });

// EGL and OSMesa have different functions, and the table of one thread must not reach the other.
TEST(TwoThreads, CanDrawWithDifferentBackEnds) {
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
