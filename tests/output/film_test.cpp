// SPDX-License-Identifier: Apache-2.0
#include "output/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>

#include "decoded_film.h"
#include "output/video_segment.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr auto kIo = core::ErrorKind::kIo;
constexpr image::PixelSize kSize = {160, 96};
const FilmTrack kTrack{FilmContainer::kMp4, {30, 1}};

class FilmTest : public FolderTest {
 protected:
  /// Writes segments of these lengths, one after the other from frame 0.
  std::vector<std::filesystem::path> segments(const std::vector<int>& lengths,
                                              const core::Rational& fps = {30, 1}) const {
    std::vector<std::filesystem::path> files;
    std::int64_t k = 0;
    for (const int length : lengths) {
      files.push_back(in("segment_" + std::to_string(k) + ".mp4"));
      writeSegment(files.back(), kSize, fps, 18, k, length);
      k += length;
    }
    return files;
  }

  static void writeSegment(const std::filesystem::path& file, image::PixelSize size, const core::Rational& fps,
                           double crf, std::int64_t first, int length) {
    VideoSegmentWriter segment(file, size, fps, h264(crf), first);
    for (std::int64_t k = first; k < first + length; ++k) segment.write({movingDisc(size, k)}, k);
    segment.finish();
  }
};

TEST_F(FilmTest, ReportsItsPropertiesToFfprobe) {
  joinSegments(segments({10, 10, 10, 10}), in("film.mp4"), kTrack, {.title = "Rolling"});
  const auto facts = probed(in("film.mp4"));
  const std::map<std::string, std::string> expected = {{"codec_name", "h264"},
                                                       {"profile", "High"},
                                                       {"width", "160"},
                                                       {"height", "96"},
                                                       {"pix_fmt", "yuv420p"},
                                                       {"color_range", "tv"},
                                                       {"color_space", "bt709"},
                                                       {"color_primaries", "bt709"},
                                                       {"color_transfer", "bt709"},
                                                       {"chroma_location", "left"},
                                                       {"sample_aspect_ratio", "1:1"},
                                                       {"r_frame_rate", "30/1"},
                                                       {"avg_frame_rate", "30/1"},
                                                       {"start_pts", "0"},
                                                       {"duration_ts", "20480"},
                                                       {"duration", "1.333333"},
                                                       {"nb_frames", "40"},
                                                       {"nb_read_packets", "40"},
                                                       {"time_base", "1/15360"},
                                                       {"TAG:title", "Rolling"},
                                                       {"TAG:encoder", "poinsot 0.1.0"}};
  for (const auto& [key, value] : expected) EXPECT_EQ(facts.count(key) ? facts.at(key) : "(none)", value) << key;
  EXPECT_EQ(facts.count("TAG:creation_time"), 0u);
}

// For any lengths and rate, film frame i is picture i at exactly i frames' time, also at the borders of segments.
TEST_F(FilmTest, HasEqualFrameTimesAcrossSegmentBorders) {
  struct Case {
    core::Rational fps;
    std::int64_t ticks;
  };
  for (const Case& c : {Case{{30, 1}, 512}, Case{{30000, 1001}, 1001}, Case{{24, 1}, 512}, Case{{25, 2}, 1024}}) {
    joinSegments(segments({7, 1, 1, 12, 2}, c.fps), in("film.mp4"), {FilmContainer::kMp4, c.fps});
    const auto frames = decoded(in("film.mp4"));
    ASSERT_EQ(frames.size(), 23u);
    for (std::size_t i = 0; i < frames.size(); ++i)
      EXPECT_EQ(frames[i].pts, static_cast<std::int64_t>(i) * c.ticks);
    for (const std::size_t border : {0u, 7u, 8u, 9u, 21u}) EXPECT_TRUE(frames[border].key) << border;
    const auto facts = probed(in("film.mp4"));
    EXPECT_EQ(facts.at("r_frame_rate"), core::toString(c.fps));
    EXPECT_EQ(facts.at("avg_frame_rate"), core::toString(c.fps));
    EXPECT_EQ(facts.at("duration_ts"), std::to_string(23 * c.ticks));
  }
}

// Joining copies packets: each frame decodes to the same bytes as in its segment.
TEST_F(FilmTest, KeepsEveryPictureUnchanged) {
  const auto files = segments({7, 9});
  joinSegments(files, in("film.mp4"), kTrack);
  auto expected = decoded(files[0]);
  const auto second = decoded(files[1]);
  expected.insert(expected.end(), second.begin(), second.end());
  const auto frames = decoded(in("film.mp4"));
  ASSERT_EQ(frames.size(), expected.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].y, expected[i].y) << i;
    EXPECT_EQ(frames[i].cb, expected[i].cb) << i;
    EXPECT_EQ(frames[i].cr, expected[i].cr) << i;
  }
}

TEST_F(FilmTest, LastsOneFrameIfItHasOneFrame) {
  joinSegments(segments({1}), in("film.mp4"), kTrack);
  const auto facts = probed(in("film.mp4"));
  EXPECT_EQ(facts.at("nb_frames"), "1");
  EXPECT_EQ(facts.at("duration_ts"), "512");
  EXPECT_EQ(decoded(in("film.mp4")).size(), 1u);
}

TEST_F(FilmTest, HasTheSameBytesEachTimeAndTheIndexFirst) {
  const auto files = segments({7, 7, 3});
  joinSegments(files, in("a.mp4"), kTrack);
  joinSegments(files, in("b.mp4"), kTrack);
  const Bytes bytes = content(in("a.mp4"));
  EXPECT_EQ(bytes, content(in("b.mp4")));
  const std::string text(bytes.begin(), bytes.end());
  for (const char* name : {"x264", "Lavc", "Lavf"}) EXPECT_EQ(text.find(name), std::string::npos) << name;
  EXPECT_LT(text.find("moov"), text.find("mdat"));
  EXPECT_EQ(text.find(in("").native()), std::string::npos);  // no path either
}

TEST_F(FilmTest, AcceptsFileNamesThatLookLikeFfmpegSyntax) {
  const auto file = in("pipe:1 'a' %d.mp4");
  joinSegments(segments({2}), file, kTrack);
  EXPECT_EQ(decoded(file).size(), 2u);
}

TEST_F(FilmTest, RefusesSegmentsOfOtherSettings) {
  const auto good = segments({4}).front();
  const auto message = [&](const std::filesystem::path& other) {
    return messageOf(kIo, [&] { joinSegments({good, other}, in("film.mp4"), kTrack); });
  };
  writeSegment(in("other_size.mp4"), {80, 48}, {30, 1}, 18, 4, 3);
  EXPECT_THAT(message(in("other_size.mp4")), HasSubstr("other_size.mp4: was encoded with other settings than"));
  writeSegment(in("other_rate.mp4"), kSize, {25, 1}, 18, 4, 3);
  EXPECT_THAT(message(in("other_rate.mp4")), HasSubstr("other_rate.mp4: has another frame rate than"));
  writeSegment(in("other_profile.mp4"), kSize, {30, 1}, 0, 4, 3);
  EXPECT_THAT(message(in("other_profile.mp4")), HasSubstr("other settings"));
  EXPECT_FALSE(std::filesystem::exists(in("film.mp4")));
}

TEST_F(FilmTest, RejectsFilesThatAreNotSegments) {
  const auto good = segments({2}).front();
  const auto message = [&](const std::filesystem::path& file) {
    return messageOf(kIo, [&] { joinSegments({good, file}, in("film.mp4"), kTrack); });
  };
  EXPECT_THAT(message(in("none.mp4")), HasSubstr("none.mp4: cannot be read"));
  EXPECT_THAT(message(save("text.mp4", "not a film at all")), HasSubstr("text.mp4: "));
  EXPECT_THAT(message(save("empty.mp4", "")), HasSubstr("empty.mp4: "));
  EXPECT_THAT(message(in("")), HasSubstr("not a regular file"));
  Bytes bytes = content(good);
  std::string foreign(bytes.begin(), bytes.end());
  foreign.replace(foreign.find("poinsot 0"), 9, "another 0");
  EXPECT_THAT(message(save("foreign.mp4", foreign)), HasSubstr("not a segment written by this version"));
  ASSERT_EQ(::mkfifo(in("fifo.mp4").c_str(), 0600), 0);
  EXPECT_THAT(message(in("fifo.mp4")), HasSubstr("not a regular file"));  // and does not wait
}

// The test moves a frame's time far away, in the table of times for frames that are shown in another order than
// decoded.
TEST_F(FilmTest, RejectsImpossibleFrameTimes) {
  const auto good = segments({10}).front();
  const Bytes whole = content(good);
  const std::string text(whole.begin(), whole.end());
  const auto entries =
      text.find("ctts") + 12;  // after its name, version and count: 4 bytes of count, 4 of time each
  ASSERT_LT(entries, text.size());
  const auto message = [&](std::size_t entry, const std::string& time) {
    std::string forged = text;
    forged.replace(entries + 8 * entry + 4, 4, time);
    return messageOf(kIo, [&] { joinSegments({save("forged.mp4", forged)}, in("film.mp4"), kTrack); });
  };
  const std::string far("\x06\x1a\x80\x00", 4);  // 200 000 frames of 512 ticks
  EXPECT_THAT(message(1, far), ::testing::ContainsRegex("has frame number 19999[0-9], which is too large$"));
  EXPECT_THAT(message(1, far.substr(0, 3) + "\x01"), HasSubstr("has a frame at a time between two frames"));
  EXPECT_THAT(message(0, far), HasSubstr("has a frame at a time between two frames"));
}

// The table of times has values that poinsot's encoders never write: one frame is shown in the place of another,
// or a frame stands further back than frames are ever reordered.
TEST_F(FilmTest, RefusesFramesInDisorder) {
  const Bytes whole = content(segments({10}).front());
  const std::string text(whole.begin(), whole.end());
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(text.at(at + i));
    return value;
  };
  const auto message = [&](std::size_t at, std::uint32_t value) {
    std::string forged = text;
    for (std::size_t i = 0; i < 4; ++i) forged.at(at + i) = static_cast<char>(value >> (24 - 8 * i));
    return messageOf(kIo, [&] { joinSegments({save("forged.mp4", forged)}, in("film.mp4"), kTrack); });
  };
  // After the table's name, its version and its count come the entries, a count and a time each.
  const std::size_t times = text.find("ctts") + 12, last = times + 8 * (number(times - 4) - 1);
  constexpr std::uint32_t kFrame = 512;  // ticks
  EXPECT_THAT(message(last + 4, number(last + 4) + kFrame), HasSubstr("forged.mp4: lacks frame"));
  EXPECT_THAT(message(last + 4, number(times + 4) - 7 * kFrame),
              HasSubstr("forged.mp4: has its frames in an order that cannot be played"));
}

// A segment that is cut, at every 23rd byte in turn, never gives a film.
TEST_F(FilmTest, RefusesATruncatedSegment) {
  const auto good = segments({5}).front();
  const Bytes whole = content(good);
  save("old.mp4", "old");
  for (std::size_t n = 0; n < whole.size(); n += 23) {
    const auto cut = save("cut.mp4", {reinterpret_cast<const char*>(whole.data()), n});
    EXPECT_NE(messageOf(kIo,
                        [&] {
                          joinSegments({good, cut}, in("old.mp4"), kTrack);
                        }),
              "")
        << n << " of " << whole.size();
  }
  EXPECT_EQ(content(in("old.mp4")).size(), 3u);
  EXPECT_THAT(names(), ElementsAre("cut.mp4", "old.mp4", "segment_0.mp4"));
}

// The disk is full at every size up to the film's. No film appears, the old file stays, and nothing temporary is
// left.
TEST_F(FilmTest, SurvivesAFullDisk) {
  const auto files = segments({5, 5});
  joinSegments(files, in("film.mp4"), kTrack);
  const Bytes before = content(in("film.mp4"));
  rlimit free{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &free), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  std::vector<std::string> messages;
  for (rlim_t limit = 0; limit < before.size(); limit += 61) {
    rlimit full = free;
    full.rlim_cur = limit;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
    messages.push_back(messageOf(kIo, [&] { joinSegments(files, in("film.mp4"), kTrack); }));
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &free), 0);
  std::signal(SIGXFSZ, handler);
  for (const auto& message : messages)
    EXPECT_THAT(message, ::testing::MatchesRegex(".*film.mp4: .*File too large.*"));
  EXPECT_GT(messages.size(), 20u);
  EXPECT_EQ(content(in("film.mp4")), before);
  EXPECT_THAT(names(), ElementsAre("film.mp4", "segment_0.mp4", "segment_5.mp4"));
}

TEST_F(FilmTest, IsRecognisedAsOurs) {
  const auto file = segments({2}).front();
  joinSegments({file}, in("film.mp4"), kTrack);
  EXPECT_TRUE(isOwnFilm(in("film.mp4")));
  EXPECT_FALSE(isOwnFilm(save("text.mp4", "poinsot 0.1.0")));
  EXPECT_FALSE(isOwnFilm(in("none.mp4")));
  EXPECT_FALSE(isOwnFilm(in("")));
  // The file is the same film with another program's name in the same place.
  Bytes bytes = content(in("film.mp4"));
  std::string text(bytes.begin(), bytes.end());
  text.replace(text.find("poinsot 0"), 9, "another 0");
  EXPECT_FALSE(isOwnFilm(save("foreign.mp4", text)));
}

}  // namespace
}  // namespace poinsot::output
