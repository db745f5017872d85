// SPDX-License-Identifier: Apache-2.0
// Captions as subtitle files. The expected texts of both formats are written by hand from their specifications.
#include "request/subtitles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.h"
#include "scene/scene_file.h"
#include "support/scratch_folder.h"

namespace poinsot::request {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

scene::Scene scene() {
  return scene::parseScene(
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [1, 0, 1]\n[time]\nduration = 3600\nfps = 1\n"
      "[[timeline]]\nat = 1.5\ncaption = \"$I_1 < I_2$ & ``so'' on\"\n"
      "[[timeline]]\nat = 3525.25\ncaption = '$\\boldsymbol{\\omega}$'\ncaption_for = 4\n",
      "test.toml");
}

constexpr FrameRange kAll{0, 3599};

TEST(Subtitles, ContainTheCaptionsAsPlainText) {
  const auto subtitles = subtitlesOf(scene(), kAll);
  ASSERT_EQ(subtitles.size(), 2u);
  EXPECT_EQ(subtitles[0].from_ms, 1500);
  EXPECT_EQ(subtitles[0].to_ms, 3525250);
  EXPECT_EQ(subtitles[1].to_ms, 3529250);
  EXPECT_EQ(subtitles[0].text.find('$'), std::string::npos);
  EXPECT_NE(subtitles[0].text.find("₁"), std::string::npos);
}

TEST(Subtitles, AreClippedToTheFrameRange) {
  const auto subtitles = subtitlesOf(scene(), {2800, 3526});
  ASSERT_EQ(subtitles.size(), 2u);
  EXPECT_EQ(subtitles[0].from_ms, 0);
  EXPECT_EQ(subtitles[0].to_ms, 725250);
  EXPECT_EQ(subtitles[1].from_ms, 725250);
  EXPECT_EQ(subtitles[1].to_ms, 727000);
  EXPECT_TRUE(subtitlesOf(scene(), {0, 0}).empty());
}

TEST(Subtitles, AreWrittenAsSubRip) {
  EXPECT_EQ(srtText({{1500, 3725250, "A < B"}, {3725250, 3729001, "ω"}}),
            "1\n00:00:01,500 --> 01:02:05,250\nA < B\n\n2\n01:02:05,250 --> 01:02:09,001\nω\n\n");
}

// Comments are blocks that begin with NOTE (WebVTT, section 4.1). sha256sum computed the digest.
TEST(Subtitles, AreWrittenAsWebVtt) {
  EXPECT_THAT(vttText({{1500, 3725250, "A < B & C > D"}}),
              MatchesRegex("WEBVTT\n\nNOTE poinsot [0-9.]+ [0-9a-f]{16}\n\nNOTE sha256 of the .srt: "
                           "67766e54c4e8ffeb9c204d08cf6161539da2c7e51f3321a8d55fbf6e937ee2a9\n\n"
                           "00:00:01.500 --> 01:02:05.250\nA &lt; B &amp; C &gt; D\n\n"));
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class SubtitleFiles : public testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { folder_.put(name, text); }
  /// Writes a film that is not poinsot's, and its subtitles.
  void make(const std::string& film, const std::vector<Subtitle>& subtitles) const {
    core::FileBatch batch;
    batch.write(in(film), std::string_view("film"));
    addSubtitles(batch, subtitles, in(film), {});
    batch.commit();
  }
  /// Returns the error for a film whose caption is "B"; empty if its files may be written.
  std::string refusal(bool force = false) const try {
    output::RunFiles files(force);
    enterSubtitles(files, {{0, 1000, "B"}}, in("a.mp4"));
    return "";
  } catch (const core::Error& error) {
    return error.what();
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(in(name)); }

  const ScratchFolder folder_;
};

TEST_F(SubtitleFiles, AreWrittenNextToTheFilm) {
  make("a.film.mp4", {{0, 1000, "A"}});
  EXPECT_EQ(textOf(in("a.film.srt")), srtText({{0, 1000, "A"}}));
  EXPECT_EQ(textOf(in("a.film.vtt")), vttText({{0, 1000, "A"}}));
}

TEST_F(SubtitleFiles, AreReplacedIfPoinsotWroteThem) {
  EXPECT_EQ(refusal(), "");
  make("a.gif", {{0, 1000, "A"}});
  EXPECT_EQ(refusal(), "");
  std::filesystem::remove(in("a.gif"));
  EXPECT_EQ(refusal(), "");
}

TEST_F(SubtitleFiles, AreProtectedIfOthersWroteOrChangedThem) {
  write("a.vtt", "WEBVTT\n\nmine");
  EXPECT_THAT(refusal(), HasSubstr("a.vtt: exists and was not written by poinsot as captions"));
  EXPECT_EQ(refusal(true), "");
  make("a.mp4", {{0, 1000, "A"}});
  write("a.srt", "1\n00:00:00,000 --> 00:00:01,000\nein A\n\n");
  EXPECT_THAT(refusal(), HasSubstr("a.srt: exists and was not written by poinsot as captions"));
  make("a.mp4", {{0, 1000, "A"}});
  write("a.vtt", textOf(in("a.vtt")) + "00:00:01.000 --> 00:00:02.000\nmine\n\n");
  EXPECT_NE(refusal(), "");
}

// A run that is killed between writing the two files leaves only the .vtt. The next run may still write its .srt.
TEST_F(SubtitleFiles, AreReplacedIfAKilledRunLeftOnlyOne) {
  make("a.mp4", {{0, 1000, "A"}});
  std::filesystem::remove(in("a.srt"));
  EXPECT_EQ(refusal(), "");
  write("a.srt", srtText({{0, 1000, "B"}}));
  EXPECT_EQ(refusal(), "");
}

TEST_F(SubtitleFiles, AreRemovedIfTheSceneHasNoCaptions) {
  make("a.mp4", {{0, 1000, "A"}});
  make("a.mp4", {});
  EXPECT_FALSE(exists("a.srt"));
  EXPECT_FALSE(exists("a.vtt"));
}

TEST_F(SubtitleFiles, AreNotRemovedIfOthersWroteOrChangedThem) {
  make("a.mp4", {{0, 1000, "A"}});
  write("a.srt", "mine");
  make("a.mp4", {});
  EXPECT_EQ(textOf(in("a.srt")), "mine");
  EXPECT_FALSE(exists("a.vtt"));
  for (const char* text : {"mine", ""}) {
    write("b.srt", text);
    write("b.vtt", text);
    make("b.mp4", {});
    EXPECT_EQ(textOf(in("b.srt")), text);
    EXPECT_EQ(textOf(in("b.vtt")), text);
  }
}

}  // namespace
}  // namespace poinsot::request
