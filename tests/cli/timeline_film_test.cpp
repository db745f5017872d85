// SPDX-License-Identifier: Apache-2.0
// A film with a timeline through the whole program: its bytes, and the captions beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kTimeline =
    "[[timeline]]\nat = 0.5\nover = 1\nshow = [\"ellipsoid\", \"polhode\"]\ncaption = 'The ellipsoid $2T$ rolls'\n"
    "[[timeline]]\nat = 1.5\nover = 0.5\nspeed = 0.2\ncamera.turn = \"90 deg\"\n"
    "[[timeline]]\nat = 3\nhold = \"0.3 s\"\ncaption = \"It stands\"\n";

class TimelineFilm : public ::testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kGoodScene + kTimeline); }

  RunResult render(const std::string& film, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"render", "a.toml", "-o", film};
    words.insert(words.end(), more.begin(), more.end());
    return run(folder_, words);
  }

  ScratchFolder folder_;
};

TEST_F(TimelineFilm, WorkersDoNotChangeAByte) {
  EXPECT_EQ(render("one.mp4", {"-j", "1"}).exitCode, 0);
  EXPECT_EQ(render("two.mp4", {"-j", "2"}).exitCode, 0);
  EXPECT_GT(bytesOf(folder_ / "one.mp4").size(), 5000u);
  EXPECT_TRUE(bytesOf(folder_ / "one.mp4") == bytesOf(folder_ / "two.mp4"));
  EXPECT_THAT(namesIn(folder_.path()),
              ElementsAre("a.toml", "one.mp4", "one.srt", "one.vtt", "two.mp4", "two.srt", "two.vtt"));
}

TEST_F(TimelineFilm, HasItsCaptionsBesideIt) {
  EXPECT_EQ(render("a.mp4", {"--frames", "0-104"}).exitCode, 0);
  EXPECT_EQ(bytesOf(folder_ / "a.srt"),
            "1\n00:00:00,500 --> 00:00:03,000\nThe ellipsoid 2T rolls\n\n"
            "2\n00:00:03,000 --> 00:00:03,500\nIt stands\n\n");
  EXPECT_EQ(bytesOf(folder_ / "a.vtt"),
            "WEBVTT\n\n00:00:00.500 --> 00:00:03.000\nThe ellipsoid 2T rolls\n\n"
            "00:00:03.000 --> 00:00:03.500\nIt stands\n\n");
}

TEST_F(TimelineFilm, LeavesOthersCaptionsAlone) {
  folder_.put("a.srt", "mine");
  const RunResult refused = render("a.mp4", {"--frames", "0-20"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err, HasSubstr("a.srt: exists and was not written by poinsot; --force replaces it"));
  EXPECT_EQ(bytesOf(folder_ / "a.srt"), "mine");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.srt", "a.toml"));
}

}  // namespace
}  // namespace poinsot
