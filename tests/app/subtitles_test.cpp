// SPDX-License-Identifier: Apache-2.0
// Captions as files: the text of both formats, written out by hand after their specifications.
#include "app/subtitles.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.h"
#include "scene/scene_file.h"
#include "support/scratch_folder.h"

namespace poinsot::app {
namespace {

scene::Scene scene() {
  return scene::parseScene(
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [1, 0, 1]\n[time]\nduration = 3600\nfps = 1\n"
      "[[timeline]]\nat = 1.5\ncaption = \"$I_1 < I_2$ & ``so'' on\"\n"
      "[[timeline]]\nat = 3525.25\ncaption = '$\\boldsymbol{\\omega}$'\ncaption_for = 4\n",
      "test.toml");
}

constexpr FrameRange kAll{0, 3599};

TEST(Subtitles, AreTheCaptionsInPlainWords) {
  const auto subtitles = subtitlesOf(scene(), kAll);
  ASSERT_EQ(subtitles.size(), 2u);
  EXPECT_EQ(subtitles[0].from_ms, 1500);
  EXPECT_EQ(subtitles[0].to_ms, 3525250);
  EXPECT_EQ(subtitles[1].to_ms, 3529250);
  EXPECT_EQ(subtitles[0].text.find('$'), std::string::npos);
  EXPECT_NE(subtitles[0].text.find("₁"), std::string::npos);
}

TEST(Subtitles, BeginAndEndWithTheFilm) {
  const auto subtitles = subtitlesOf(scene(), {2800, 3526});
  ASSERT_EQ(subtitles.size(), 2u);
  EXPECT_EQ(subtitles[0].from_ms, 0);
  EXPECT_EQ(subtitles[0].to_ms, 725250);
  EXPECT_EQ(subtitles[1].from_ms, 725250);
  EXPECT_EQ(subtitles[1].to_ms, 727000);
  EXPECT_TRUE(subtitlesOf(scene(), {0, 0}).empty());
}

TEST(Subtitles, AsSubRip) {
  EXPECT_EQ(srtText({{1500, 3725250, "A < B"}, {3725250, 3729001, "ω"}}),
            "1\n00:00:01,500 --> 01:02:05,250\nA < B\n\n2\n01:02:05,250 --> 01:02:09,001\nω\n\n");
}

TEST(Subtitles, AsWebVtt) {
  EXPECT_EQ(vttText({{1500, 3725250, "A < B & C > D"}}),
            "WEBVTT\n\n00:00:01.500 --> 01:02:05.250\nA &lt; B &amp; C &gt; D\n\n");
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Subtitles, AreWrittenBesideTheFilm) {
  const ScratchFolder folder;
  const auto film = folder.path() / "a.film.mp4";
  writeSubtitles({{0, 1000, "A"}}, film);
  EXPECT_EQ(textOf(folder.path() / "a.film.srt"), srtText({{0, 1000, "A"}}));
  EXPECT_EQ(textOf(folder.path() / "a.film.vtt"), vttText({{0, 1000, "A"}}));
}

TEST(Subtitles, DoNotReplaceWhatIsNotOurs) {
  const ScratchFolder folder;
  const auto film = folder.path() / "a.mp4";
  EXPECT_NO_THROW(checkSubtitleFiles(film, false));
  std::ofstream(folder.path() / "a.vtt") << "mine";
  EXPECT_THROW(checkSubtitleFiles(film, false), core::Error);
  EXPECT_NO_THROW(checkSubtitleFiles(film, true));
}

}  // namespace
}  // namespace poinsot::app
