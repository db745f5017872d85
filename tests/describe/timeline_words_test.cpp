// SPDX-License-Identifier: Apache-2.0
#include "describe/timeline_words.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "request/scene_request.h"

namespace poinsot::describe {
namespace {

// Turns at 1 rad/s about e3, so that the motion time equals the film time until the speed changes.
constexpr const char* kSpinning =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 1]\n[time]\nduration = 20\nspeed = 1\n";

std::vector<TimelineWords> entriesIn(const std::string& entries) {
  return timelineWords(request::loadRequested({"made.toml", kSpinning + entries, {}, std::nullopt}));
}

std::string entryText(const std::string& keys) {
  const auto words = entriesIn("[[timeline]]\nat = 3\n" + keys);
  EXPECT_EQ(words.size(), 1u);
  return words.front().text;
}

TEST(TimelineWords, AreEmptyWithoutTimeline) { EXPECT_TRUE(entriesIn("").empty()); }

TEST(TimelineWords, AreSortedByFilmTime) {
  const auto words = entriesIn(
      "[[timeline]]\nat = 5\ncaption = 'b'\n[[timeline]]\nat = '500 ms'\ncaption = 'a'\n"
      "[[timeline]]\nat_motion = 7\nspeed = 0.5\n[[timeline]]\naround = 12\nhold = 2\n");
  ASSERT_EQ(words.size(), 4u);
  EXPECT_DOUBLE_EQ(words[0].at_s, 0.5);
  EXPECT_EQ(words[0].text, "“a”");
  EXPECT_EQ(words[0].moment, "");
  EXPECT_DOUBLE_EQ(words[1].at_s, 5);
  EXPECT_NEAR(words[2].at_s, 7, 1e-9);
  EXPECT_EQ(words[2].moment, "motion time 7 s");
  EXPECT_LT(words[3].at_s, 12) << "12 s is the middle of the pause";
  EXPECT_EQ(words[3].moment, "around 12 s");
  EXPECT_EQ(words[3].text, "pause of 2 s");
}

TEST(TimelineWords, NameTheEventOfAnEntry) {
  // A flip of a book: omega_2 changes sign. The first one comes within 20 s.
  const std::string book =
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.01, 2, 0.01]\n[time]\nduration = 20\n"
      "speed = 1\n[[timeline]]\nat = \"flip 1\"\ncaption = 'now'\n";
  const auto words = timelineWords(request::loadRequested({"made.toml", book, {}, std::nullopt}));
  ASSERT_EQ(words.size(), 1u);
  EXPECT_EQ(words[0].moment, "flip 1");
}

TEST(TimelineWords, DescribeEachChange) {
  EXPECT_EQ(entryText("caption = '$\\omega_2$ turns'\n"), "“ω₂ turns”");
  EXPECT_EQ(entryText("caption = ''\n"), "no caption");
  EXPECT_EQ(entryText("speed = 0.25\nspeed_for = '3 s'\n"), "speed 0.25 for 3 s");
  EXPECT_EQ(entryText("show = ['omega', 'L', 'labels']\nhide = ['title']\n"),
            "show omega, L and labels; hide title");
  EXPECT_EQ(entryText("camera.azimuth = '40 deg'\ncamera.elevation = '-10 deg'\ncamera.zoom = 1.5\n"),
            "camera azimuth 40°, elevation -10° and zoom 1.5");
  EXPECT_EQ(entryText("caption = 'Here.'\nspeed = 2\ncamera.turn = '90 deg'\n"),
            "“Here.”; speed 2; camera turn 90°");
}

}  // namespace
}  // namespace poinsot::describe
