// SPDX-License-Identifier: Apache-2.0
// Every kind of film is written as segments, joined, and read back by ffprobe and ffmpeg as processes. The
// pictures must be those that were written, and the file's tags must be true.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "decoded_film.h"
#include "output/ffmpeg_encoder.h"
#include "output/film.h"
#include "output/film_format.h"
#include "output/film_reader.h"
#include "output/video_segment.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

using ::testing::HasSubstr;

using Box = FilmContainer;
using Codec = FilmCodec;

constexpr image::PixelSize kSize = {128, 64};
constexpr int kCells = 4, kRows = 2, kCell = 32;

/// Returns flat squares of the primaries, their complements, black and white, which change places from frame to
/// frame. If `transparent` is set, each next square lets more through.
image::Image primaries(std::int64_t k, bool transparent) {
  image::Image picture(kSize, transparent ? 4 : 3);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const int cell = (x / kCell + kCells * (y / kCell) + static_cast<int>(k)) % (kCells * kRows);
      std::uint8_t* p = picture.at(x, y);
      for (int c = 0; c < 3; ++c) p[c] = (cell >> c & 1) != 0 ? 255 : 0;
      if (transparent) p[3] = static_cast<std::uint8_t>(255 - 30 * cell);
    }
  return picture;
}

struct Format {
  const char* name;
  FilmFormat format;
  std::map<std::string, std::string> facts;  ///< expected from ffprobe
  int tolerance;  ///< of a colour in the middle of a square, in levels; measured 1, VP9 with alpha 2, AV1 2 and 3
};

FilmFormat of(FilmContainer container, FilmCodec codec, Chroma chroma = Chroma::k420, bool transparent = false,
              double crf = 9) {
  return {container, codec, chroma, Effort::kFast, transparent, crf};
}

const std::map<std::string, std::string> kBt709{
    {"color_range", "tv"}, {"color_space", "bt709"}, {"color_primaries", "bt709"}, {"color_transfer", "bt709"}};

std::map<std::string, std::string> with(std::map<std::string, std::string> facts) {
  facts.insert(kBt709.begin(), kBt709.end());
  return facts;
}

/// Returns facts without the colour range, for which QuickTime has no place: FFmpeg 5 assumes a range, FFmpeg 7
/// none.
std::map<std::string, std::string> withoutRange(std::map<std::string, std::string> facts) {
  facts = with(std::move(facts));
  facts.erase("color_range");
  return facts;
}

std::vector<Format> formats() {
  return {
      {"H264", of(Box::kMp4, Codec::kH264),
       with({{"codec_name", "h264"}, {"profile", "High"}, {"pix_fmt", "yuv420p"}}), 2},
      {"H264Fine", of(Box::kMp4, Codec::kH264, Chroma::k444),
       with({{"codec_name", "h264"}, {"profile", "High 4:4:4 Predictive"}, {"pix_fmt", "yuv444p"}}), 2},
      {"H264Lossless", of(Box::kMp4, Codec::kH264, Chroma::k444, false, 0), with({{"codec_name", "h264"}}), 2},
      {"Hevc", of(Box::kMp4, Codec::kHevc),
       with({{"codec_name", "hevc"}, {"codec_tag_string", "hvc1"}, {"pix_fmt", "yuv420p"}, {"profile", "Main"}}),
       2},
      {"HevcFine", of(Box::kMp4, Codec::kHevc, Chroma::k444),
       with({{"codec_name", "hevc"}, {"pix_fmt", "yuv444p"}}), 2},
      {"HevcLossless", of(Box::kMp4, Codec::kHevc, Chroma::k444, false, 0), with({{"codec_name", "hevc"}}), 2},
      {"Vp9", of(Box::kWebm, Codec::kVp9), with({{"codec_name", "vp9"}, {"pix_fmt", "yuv420p"}}), 2},
      {"Vp9Fine", of(Box::kWebm, Codec::kVp9, Chroma::k444), with({{"codec_name", "vp9"}, {"pix_fmt", "yuv444p"}}),
       2},
      {"Vp9Lossless", of(Box::kWebm, Codec::kVp9, Chroma::k444, false, 0), with({{"codec_name", "vp9"}}), 2},
      {"Vp9Transparent", of(Box::kWebm, Codec::kVp9, Chroma::k420, true),
       with({{"codec_name", "vp9"}, {"TAG:ALPHA_MODE", "1"}}), 2},
      {"Av1", of(Box::kWebm, Codec::kAv1), with({{"codec_name", "av1"}, {"pix_fmt", "yuv420p"}}), 3},
      {"ProRes", of(Box::kMov, Codec::kProRes),
       withoutRange(
           {{"codec_name", "prores"}, {"profile", "4444"}, {"codec_tag_string", "ap4h"}, {"nb_frames", "17"}}),
       2},
      {"ProResTransparent", of(Box::kMov, Codec::kProRes, Chroma::k420, true),
       withoutRange({{"codec_name", "prores"}, {"pix_fmt", "yuva444p12le"}}), 2},
      {"Gif", of(Box::kGif, Codec::kGif), {{"codec_name", "gif"}}, 0},
      {"Apng", of(Box::kApng, Codec::kApng), {{"codec_name", "apng"}, {"pix_fmt", "rgb24"}}, 0},
      {"ApngTransparent",
       of(Box::kApng, Codec::kApng, Chroma::k420, true),
       {{"codec_name", "apng"}, {"pix_fmt", "rgba"}},
       0},
  };
}

const FilmTexts kTexts{"Primaries", "In words.", "of here; ", "a test"};

class FilmFormats : public FolderTest, public testing::WithParamInterface<Format> {
 protected:
  void SetUp() override {
    if (const char* missing = missingEncoder(GetParam().format.codec)) GTEST_SKIP() << "no encoder " << missing;
  }
  static bool transparent() { return GetParam().format.transparent; }

  /// Writes a film of two segments, 10 and 7 frames long.
  std::filesystem::path film(const std::string& name = "film") const {
    const FilmFormat& format = GetParam().format;
    std::vector<std::filesystem::path> segments;
    for (const auto& [first, count] : {std::pair(0, 10), std::pair(10, 7)}) {
      segments.push_back(in("segment_" + std::to_string(first)));
      VideoSegmentWriter segment(segments.back(), kSize, {25, 1}, format, first);
      for (int k = first; k < first + count; ++k) segment.write({primaries(k, transparent())}, k);
      segment.finish();
    }
    const auto file = in(name + "." + std::string(nameOf(format.container)));
    joinSegments(segments, file, {format.container, {25, 1}}, kTexts);
    return file;
  }
};

TEST_P(FilmFormats, ReportsItsFormatToFfprobe) {
  const auto facts = probed(film());
  for (const auto& [key, value] : GetParam().facts)
    EXPECT_EQ(facts.count(key) ? facts.at(key) : "(none)", value) << key;
  EXPECT_EQ(facts.at("nb_read_packets"), "17");
  EXPECT_EQ(facts.at("width"), "128");
  EXPECT_EQ(facts.at("height"), "64");
  EXPECT_EQ(facts.at("r_frame_rate"), "25/1");
}

/// Largest distance of pictures from what was drawn, in the middle of each square, in levels.
struct Distance {
  int color = 0, alpha = 0;
};

Distance distance(const std::vector<image::Image>& pictures, bool transparent) {
  Distance worst;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const image::Image expected = primaries(static_cast<std::int64_t>(k), transparent);
    for (int y = kCell / 2; y < kSize.height; y += kCell)
      for (int x = kCell / 2; x < kSize.width; x += kCell) {
        const std::uint8_t *is = pictures[k].at(x, y), *was = expected.at(x, y);
        for (int c = 0; c < 3; ++c) worst.color = std::max(worst.color, std::abs(is[c] - was[c]));
        const int alpha = pictures[k].channels == 4 ? is[3] : 255;
        worst.alpha = std::max(worst.alpha, std::abs(alpha - (transparent ? was[3] : 255)));
      }
  }
  return worst;
}

// Expected: what was drawn. ffmpeg gets no options for colour, so that it goes by the file's tags.
TEST_P(FilmFormats, ShowsTheColorsThatWereDrawn) {
  const auto pictures = shown(film(), kSize, 17);
  ASSERT_EQ(pictures.size(), 17u);
  const Distance worst = distance(pictures, transparent());
  EXPECT_LE(worst.color, GetParam().tolerance);
  EXPECT_LE(worst.alpha, GetParam().tolerance);
  RecordProperty("worst", worst.color);
  RecordProperty("worstAlpha", worst.alpha);
}

/// Returns a picture of 8 bits, rounded if the original has 16.
image::Image flattened(const image::AnyImage& picture) {
  if (const auto* flat = std::get_if<image::Image>(&picture)) return *flat;
  const auto& deep = std::get<image::DeepImage>(picture);
  image::Image flat(deep.size, deep.channels);
  std::ranges::transform(deep.pixels, flat.pixels.begin(),
                         [](std::uint16_t v) { return static_cast<std::uint8_t>((v + 128) / 257); });
  return flat;
}

TEST_P(FilmFormats, FilmReaderReturnsTheWrittenPictures) {
  FilmReader reader(film());
  EXPECT_EQ(reader.size(), kSize);
  EXPECT_EQ(reader.fps(), (core::Rational{25, 1}));
  std::vector<image::Image> pictures;
  while (const auto shown = reader.next()) pictures.push_back(flattened(shown->picture));
  ASSERT_EQ(pictures.size(), 17u);
  const Distance worst = distance(pictures, transparent());
  EXPECT_LE(worst.color, GetParam().tolerance);
  EXPECT_LE(worst.alpha, GetParam().tolerance);
}

TEST_P(FilmFormats, HasTheSameBytesEachTime) { EXPECT_EQ(content(film("a")), content(film("b"))); }

/// Returns the text of a user data atom, which has a name, 16 bits of length and 16 of language (QuickTime File
/// Format, "User Data").
std::string atomText(const std::string& bytes, const std::string& name) {
  const auto at = bytes.find(name);
  if (at == bytes.npos) return "(none)";
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i]));
  };
  return bytes.substr(at + 8, 256 * byte(4) + byte(5));
}

// Players show this text of a QuickTime film. Films of other kinds have the text under libav's own name.
TEST_P(FilmFormats, HasTheDescriptionInItsTags) {
  const auto box = GetParam().format.container;
  const auto bytes = content(film());
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("In words."), text.npos);
  if (box != FilmContainer::kMov) return;
  EXPECT_EQ(atomText(text,
                     "\xa9"
                     "des"),
            "In words.");
  EXPECT_THAT(probed(film()).at("TAG:model"), testing::MatchesRegex("of here; film sha256 [0-9a-f]+; a test"));
}

TEST_P(FilmFormats, TruncatedFilmIsReportedAsDamaged) {
  const auto file = film();
  EXPECT_TRUE(isOwnFilm(file));
  EXPECT_EQ(filmState(file, kTexts.origin), FilmState::kWhole);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
  EXPECT_EQ(filmState(file, kTexts.origin), FilmState::kDamaged);
}

class GifOrApngFilm : public FolderTest, public ::testing::WithParamInterface<FilmContainer> {
 protected:
  std::filesystem::path segment(const std::string& name, const image::Image& picture) const {
    const FilmFormat format = of(GetParam(), codecsOf(GetParam()).front(), Chroma::k420, picture.channels == 4);
    VideoSegmentWriter writer(in(name), picture.size, {25, 1}, format, 0);
    writer.write({picture}, 0);
    writer.finish();
    return in(name);
  }
  std::string refusal(const std::vector<std::filesystem::path>& segments) const {
    return messageOf(core::ErrorKind::kIo, [&] { joinSegments(segments, in("film"), {GetParam(), {25, 1}}, {}); });
  }
};

// The file has room for pictures of the size of the first only.
TEST_P(GifOrApngFilm, RejectsPicturesOfAnotherSizeOrKind) {
  const auto first = segment("first.mkv", primaries(0, false)),
             large = segment("large.mkv", image::Image({2 * kSize.width, 2 * kSize.height}, 3));
  EXPECT_EQ(refusal({first, first}), "");
  EXPECT_THAT(refusal({first, large}), HasSubstr("large.mkv: has pictures of another size or kind"));
  EXPECT_THAT(refusal({large, first}), HasSubstr("first.mkv: has pictures of another size or kind"));
  if (GetParam() == Box::kGif) return;  // pictures of a GIF have no alpha
  const auto alpha = segment("alpha.mkv", primaries(0, true));
  EXPECT_THAT(refusal({first, alpha}), HasSubstr("alpha.mkv: has pictures of another size or kind"));
}

INSTANTIATE_TEST_SUITE_P(All, GifOrApngFilm, testing::Values(Box::kGif, Box::kApng),
                         [](const auto& tested) { return tested.param == Box::kGif ? "Gif" : "Apng"; });

class FilmReaderTest : public FolderTest {};

TEST_F(FilmReaderTest, DoesNotWaitForAPipe) {
  ASSERT_EQ(::mkfifo(in("fifo.mp4").c_str(), 0600), 0);
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { FilmReader(in("fifo.mp4")); }),
              HasSubstr("not a regular file"));
  EXPECT_FALSE(isOwnFilm(in("fifo.mp4")));
  ASSERT_EQ(::mkfifo(in("fifo.gif").c_str(), 0600), 0);
  EXPECT_FALSE(isOwnFilm(in("fifo.gif")));
}

// In Matroska the width, which has two bytes here, stands after the mark and the length of its element.
TEST_F(FilmReaderTest, RejectsTooLargePictures) {
  const image::PixelSize size{320, 64};
  VideoSegmentWriter writer(in("a.mkv"), size, {25, 1}, of(Box::kApng, Codec::kApng), 0);
  writer.write({image::Image(size, 3)}, 0);
  writer.finish();
  const Bytes whole = content(in("a.mkv"));
  std::string text(whole.begin(), whole.end());
  const auto width = text.find(std::string("\xb0\x82\x01\x40", 4));
  ASSERT_NE(width, text.npos);
  EXPECT_EQ(FilmReader(in("a.mkv")).size(), size);
  text.replace(width + 2, 2, "\xff\xff");
  const auto file = save("b.mkv", text);
  EXPECT_THAT(
      messageOf(core::ErrorKind::kLimit, [&] { FilmReader reader(file); }),
      HasSubstr("b.mkv: the pictures are 65535x64 pixels; at most 16384 per side and 64 million pixels are read"));
}

// The file holds two films, one behind the other, as ffmpeg copies them into one.
TEST_F(FilmReaderTest, RejectsPicturesThatChangeTheirSize) {
  const std::string make = "ffmpeg -v error -f lavfi -i color=rate=25:size=";
  const std::string commands = "cd '" + in("").native() + "' && " + make + "320x64 -frames:v 2 a.ts && " + make +
                               "256x64 -frames:v 2 b.ts && cat a.ts b.ts > ab.ts && " +
                               "ffmpeg -v error -i ab.ts -c copy ab.mp4";
  ASSERT_EQ(std::system(commands.c_str()), 0);
  const auto readAll = [&] {
    FilmReader reader(in("ab.mp4"));
    while (reader.next()) continue;
  };
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, readAll), HasSubstr("ab.mp4: its pictures differ in size"));
}

INSTANTIATE_TEST_SUITE_P(All, FilmFormats, testing::ValuesIn(formats()),
                         [](const auto& tested) { return tested.param.name; });

// ---- refusals

std::string refusal(const FilmFormat& format, image::PixelSize size = kSize, const core::Rational& fps = {25, 1}) {
  return messageOf(core::ErrorKind::kUsage, [&] { checkFormat(format, size, fps); });
}

TEST(FilmFormatErrors, NamePossibleAlternatives) {
  EXPECT_EQ(refusal(of(Box::kMp4, Codec::kVp9)),
            "codec vp9: not possible in a .mp4, which can contain: h264, hevc");
  EXPECT_EQ(refusal(of(Box::kMp4, Codec::kH264, Chroma::k420, true)),
            "h264 in a .mp4 has no half-transparent pixels; use vp9 in a .webm, prores in a .mov, .apng or "
            "numbered pictures");
  EXPECT_EQ(refusal(of(Box::kWebm, Codec::kAv1, Chroma::k420, true)).substr(0, 45),
            "av1 in a .webm has no half-transparent pixels");
  EXPECT_EQ(refusal(of(Box::kWebm, Codec::kAv1, Chroma::k444)),
            "chroma 4:4:4: not possible with av1, only with h264, hevc, prores, vp9, gif, apng");
  EXPECT_EQ(refusal(of(Box::kWebm, Codec::kAv1, Chroma::k420, false, 0)),
            "crf 0: av1 is never lossless; h264, hevc, vp9, apng can be");
  EXPECT_THAT(refusal(of(Box::kWebm, Codec::kVp9, Chroma::k444, true)), HasSubstr("prores in a .mov has both"));
  EXPECT_EQ(refusal(of(Box::kGif, Codec::kGif), kSize, {60, 1}),
            "a .gif of 60 frames/s: its players show at most 50");
  EXPECT_THAT(refusal(of(Box::kMp4, Codec::kH264), {129, 64}), HasSubstr("width and height must be even"));
  EXPECT_EQ(refusal(of(Box::kMp4, Codec::kH264, Chroma::k444), {129, 63}), "");
  EXPECT_EQ(refusal(of(Box::kGif, Codec::kGif), {129, 63}), "");
}

}  // namespace
}  // namespace poinsot::output
