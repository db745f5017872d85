// SPDX-License-Identifier: Apache-2.0
// Tests a film with a timeline through the whole program: its bytes, and the captions beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

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

TEST_F(TimelineFilm, HasTheSameBytesWithAnyNumberOfWorkers) {
  EXPECT_EQ(render("one.mp4", {"-j", "1"}).exitCode, 0);
  EXPECT_EQ(render("two.mp4", {"-j", "2"}).exitCode, 0);
  EXPECT_GT(bytesOf(folder_ / "one.mp4").size(), 5000u);
  EXPECT_TRUE(bytesOf(folder_ / "one.mp4") == bytesOf(folder_ / "two.mp4"));
  EXPECT_THAT(namesIn(folder_.path()),
              ElementsAre("a.toml", "one.mp4", "one.srt", "one.vtt", "two.mp4", "two.srt", "two.vtt"));
}

TEST_F(TimelineFilm, WritesCaptionsNextToTheFilm) {
  EXPECT_EQ(render("a.mp4", {"--frames", "0-104"}).exitCode, 0);
  EXPECT_EQ(bytesOf(folder_ / "a.srt"),
            "1\n00:00:00,500 --> 00:00:03,000\nThe ellipsoid 2T rolls\n\n"
            "2\n00:00:03,000 --> 00:00:03,500\nIt stands\n\n");
  EXPECT_THAT(bytesOf(folder_ / "a.vtt"), StartsWith("WEBVTT\n\nNOTE poinsot "));
  EXPECT_THAT(bytesOf(folder_ / "a.vtt"), EndsWith("\n\n00:00:00.500 --> 00:00:03.000\nThe ellipsoid 2T rolls\n\n"
                                                   "00:00:03.000 --> 00:00:03.500\nIt stands\n\n"));
}

TEST_F(TimelineFilm, DoesNotReplaceForeignCaptions) {
  folder_.put("a.srt", "mine");
  const RunResult refused = render("a.mp4", {"--frames", "0-20"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err,
              HasSubstr("a.srt: exists and was not written by poinsot as captions; --force replaces it"));
  EXPECT_EQ(bytesOf(folder_ / "a.srt"), "mine");
  EXPECT_THAT(namesIn(folder_.path()), ElementsAre("a.srt", "a.toml"));
}

const std::vector<std::string> kFilms{"a.mp4", "a.mov", "a.webm", "a.gif", "a.apng"};
const std::string kSequence = "a_{frame}.png";  // has no subtitles, and keeps those of a film
const std::string kCaptioned =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 3, 0]\n"
    "[time]\nduration = 0.2\nfps = 10\n[output]\nsize = [16, 16]\n"
    "[[timeline]]\nat = 0\ncaption = 'A $2T$'\n";
const std::string kCaptionedSrt = "1\n00:00:00,000 --> 00:00:00,200\nA 2T\n\n";

RunResult renderTo(const ScratchFolder& folder, const std::string& output, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"render", "a.toml", "-o", output, "-j", "1"});
  return run(folder, more);
}

class FilmsWithTheSameName : public ::testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kCaptioned); }
  RunResult render(const std::string& output, const std::vector<std::string>& more = {}) const {
    return renderTo(folder_, output, more);
  }
  ScratchFolder folder_;
};

/// Renders the first output, then each of the others beside a copy of it.
void expectSharedSubtitles(const std::string& first, const std::vector<std::string>& seconds) {
  const ScratchFolder before;
  before.put("a.toml", kCaptioned);
  EXPECT_EQ(renderTo(before, first).exitCode, 0) << first;
  for (const std::string& second : seconds) {
    if (second == first) continue;
    const ScratchFolder folder;
    std::filesystem::copy(before.path(), folder.path());
    const RunResult made = renderTo(folder, second);
    EXPECT_EQ(made.exitCode, 0) << second << " after " << first << ": " << made.err;
    EXPECT_THAT(made.err, Not(HasSubstr("a.srt"))) << "the captions are the same";
    EXPECT_EQ(bytesOf(folder / "a.srt"), kCaptionedSrt);
    EXPECT_THAT(bytesOf(folder / "a.vtt"), EndsWith("\n\n00:00:00.000 --> 00:00:00.200\nA 2T\n\n"));
  }
}

TEST(PairsOfFilms, ShareSubtitlesIfTheyHaveTheSameName) {
  std::vector<std::string> outputs = kFilms;
  outputs.push_back(kSequence);
  for (const std::string& first : outputs) expectSharedSubtitles(first, outputs);
}

TEST_F(FilmsWithTheSameName, KeepSubtitlesOfTheUser) {
  for (const std::string& film : kFilms) EXPECT_EQ(render(film).exitCode, 0) << film;
  for (const std::string name : {"a.srt", "a.vtt"}) {
    folder_.put(name, "mine");
    for (const std::string& film : kFilms) {
      const RunResult refused = render(film);
      EXPECT_EQ(refused.exitCode, 4) << film;
      EXPECT_THAT(refused.err,
                  HasSubstr(name + ": exists and was not written by poinsot as captions; --force replaces it"));
      EXPECT_EQ(bytesOf(folder_ / name), "mine") << film;
    }
    EXPECT_EQ(render("a.gif", {"--force"}).exitCode, 0);
    EXPECT_THAT(bytesOf(folder_ / name), HasSubstr("A 2T"));
  }
}

// A player shows the captions of the last film.
TEST_F(FilmsWithTheSameName, NoteThatTheirCaptionsDiffer) {
  EXPECT_EQ(render("a.mp4").exitCode, 0);
  const RunResult shorter = render("a.gif", {"--frames", "0-0"});
  EXPECT_EQ(shorter.exitCode, 0);
  EXPECT_THAT(shorter.err,
              HasSubstr("note: a.srt and a.vtt are replaced by the captions of a.gif, which differ; if the old "
                        "captions belong to a.mp4, give one of the two films another name"));
  EXPECT_EQ(bytesOf(folder_ / "a.srt"), "1\n00:00:00,000 --> 00:00:00,100\nA 2T\n\n");
}

TEST_F(FilmsWithTheSameName, KeepSubtitlesOfTheUserWhenTheyAreAssembled) {
  EXPECT_EQ(render("a.mp4", {"--shard", "1/1"}).exitCode, 0);
  folder_.put("a.srt", "mine");
  const RunResult refused = run(folder_, {"assemble", "a.mp4"});
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_THAT(refused.err, HasSubstr("a.srt: exists and was not written by poinsot"));
  EXPECT_EQ(bytesOf(folder_ / "a.srt"), "mine");
  EXPECT_EQ(run(folder_, {"assemble", "a.mp4", "--force"}).exitCode, 0);
  EXPECT_EQ(bytesOf(folder_ / "a.srt"), kCaptionedSrt);
}

}  // namespace
}  // namespace poinsot
