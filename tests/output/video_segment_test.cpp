// SPDX-License-Identifier: Apache-2.0
#include "output/video_segment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>

#include "decoded_film.h"
#include "output/yuv.h"
#include "support/folder_test.h"
#include "support/sanitized.h"
#include "support/text_of.h"

namespace poinsot::output {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr image::PixelSize kSize = {160, 96};
constexpr core::Rational kFps = {30, 1};

void writeSegment(const std::filesystem::path& file, std::int64_t first, std::int64_t count, double crf = 18) {
  VideoSegmentWriter segment(file, kSize, kFps, h264(crf), first);
  for (std::int64_t k = first; k < first + count; ++k) segment.write({movingDisc(kSize, k)}, k);
  segment.finish();
}

double meanError(const DecodedFrame& frame, std::int64_t k) {
  std::vector<std::uint8_t> y(160 * 96), cb(80 * 48), cr(80 * 48);
  convertToYuv420(movingDisc(kSize, k), {y.data(), cb.data(), cr.data(), 160, 80, 80});
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += std::abs(y[i] - frame.y[i]);
  for (std::size_t i = 0; i < cb.size(); ++i) sum += std::abs(cb[i] - frame.cb[i]) + std::abs(cr[i] - frame.cr[i]);
  return sum / 1.5 / static_cast<double>(y.size());
}

class VideoSegmentTest : public FolderTest {};

// Each k has a picture of its own: frames k and k + 1 differ by 1.65 levels in the mean.
TEST_F(VideoSegmentTest, DecodesToTheWrittenFrames) {
  for (const std::int64_t count : {1, 2, 3, 7, 40}) {
    writeSegment(in("s.mp4"), 5, count);
    const auto frames = decoded(in("s.mp4"));
    ASSERT_EQ(static_cast<std::int64_t>(frames.size()), count);
    EXPECT_TRUE(frames[0].key);
    for (std::int64_t i = 0; i < count; ++i) {
      const auto& frame = frames[static_cast<std::size_t>(i)];
      EXPECT_EQ(frame.pts, i * 512);
      EXPECT_LE(meanError(frame, 5 + i), 0.6) << i << " of " << count;  // measured at most 0.32
    }
  }
}

image::PixelRect placeOfDifferences(const image::Image& a, const image::Image& b) {
  image::PixelRect place{a.size.width, a.size.height, 0, 0};
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x) {
      if (std::equal(a.at(x, y), a.at(x, y) + a.channels, b.at(x, y))) continue;
      place = {std::min(place.left, x), std::min(place.top, y), std::max(place.right, x + 1),
               std::max(place.bottom, y + 1)};
    }
  return place;
}

// Frames that report where they differ from the frame before make the same file, also with a gap and with a frame
// without report.
TEST_F(VideoSegmentTest, HasTheSameBytesIfFramesReportChanges) {
  constexpr std::int64_t kFrames = 12;
  writeSegment(in("all.mp4"), 0, kFrames);
  VideoSegmentWriter segment(in("told.mp4"), kSize, kFps, h264(18), 0);
  for (std::int64_t k = 0; k < kFrames; ++k) {
    const image::AnyImage picture = movingDisc(kSize, k);
    const std::array changed{
        placeOfDifferences(movingDisc(kSize, k), movingDisc(kSize, std::max<std::int64_t>(k - 1, 0)))};
    const std::uint64_t number = k == 8 ? 0 : static_cast<std::uint64_t>(k < 4 ? k + 1 : k + 10);
    const bool follows = k > 0 && k != 4 && k != 8 && k != 9;  // else the reported place must be ignored
    segment.write({picture, number,
                   follows ? std::span<const image::PixelRect>(changed) : std::span<const image::PixelRect>()},
                  k);
  }
  segment.finish();
  EXPECT_EQ(textOf(in("told.mp4")), textOf(in("all.mp4")));
}

TEST_F(VideoSegmentTest, IsLosslessAtCrf0) {
  writeSegment(in("s.mp4"), 0, 5, 0);
  const auto frames = decoded(in("s.mp4"));
  ASSERT_EQ(frames.size(), 5u);
  for (std::int64_t i = 0; i < 5; ++i) EXPECT_EQ(meanError(frames[static_cast<std::size_t>(i)], i), 0);
}

TEST_F(VideoSegmentTest, HasTheSameBytesEachTimeAndNoEncoderNames) {
  writeSegment(in("a.mp4"), 3, 12);
  writeSegment(in("b.mp4"), 3, 12);
  const Bytes bytes = content(in("a.mp4"));
  EXPECT_EQ(bytes, content(in("b.mp4")));
  const std::string text(bytes.begin(), bytes.end());
  for (const char* name : {"x264", "Lavc", "Lavf"}) EXPECT_EQ(text.find(name), std::string::npos) << name;
  EXPECT_NE(text.find("colr"), std::string::npos);
}

TEST_F(VideoSegmentTest, AppearsOnlyWhenFinished) {
  {
    VideoSegmentWriter segment(in("s.mp4"), kSize, kFps, h264(18), 0);
    for (int k = 0; k < 50; ++k) segment.write({movingDisc(kSize, k)}, k);
    EXPECT_FALSE(std::filesystem::exists(in("s.mp4")));
  }
  EXPECT_THAT(names(), IsEmpty());
  writeSegment(in("s.mp4"), 0, 2);
  EXPECT_THAT(names(), ElementsAre("s.mp4"));
}

TEST_F(VideoSegmentTest, RefusesOddSizesAndQualityOutOfRange) {
  const auto message = [&](image::PixelSize size, double crf) {
    return messageOf(core::ErrorKind::kUsage, [&] { VideoSegmentWriter(in("s.mp4"), size, kFps, h264(crf), 0); });
  };
  EXPECT_THAT(message({161, 96}, 18), HasSubstr("161x96 pixels: width and height must be even"));
  EXPECT_THAT(message({160, 97}, 18), HasSubstr("the nearest is 160x96"));
  EXPECT_THAT(message({160, 96}, 51.5), HasSubstr("crf 51.5"));
  EXPECT_THAT(message({160, 96}, -1), HasSubstr("crf -1"));
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(VideoSegmentTest, KeepsTheExactFrameRateOrRejectsIt) {
  const auto ticks = [&](const core::Rational& fps) {
    VideoSegmentWriter segment(in("s.mp4"), kSize, fps, h264(18), 0);
    for (int k = 0; k < 3; ++k) segment.write({movingDisc(kSize, k)}, k);
    segment.finish();
    return decoded(in("s.mp4")).at(2).pts / 2;
  };
  EXPECT_EQ(ticks({1, 60}), 60 * 16384);
  EXPECT_EQ(ticks({999'999'999, 10'000'000}), 10'000'000);
  EXPECT_EQ(ticks({1000, 1}), 16);
  EXPECT_THAT(messageOf(core::ErrorKind::kUsage,
                        [&] {
                          ticks({1, 1'000'000});
                        }),
              HasSubstr("1/1000000 frames per second"));
}

TEST_F(VideoSegmentTest, RejectsFramesOutOfOrder) {
  VideoSegmentWriter segment(in("s.mp4"), kSize, kFps, h264(18), 4);
  EXPECT_THROW(segment.write({movingDisc(kSize, 3)}, 3), std::logic_error);
  segment.write({movingDisc(kSize, 4)}, 4);
  EXPECT_THROW(segment.write({movingDisc(kSize, 6)}, 6), std::logic_error);
  EXPECT_THROW(segment.write({movingDisc({80, 48}, 5)}, 5), std::logic_error);
}

TEST_F(VideoSegmentTest, NamesThePathItCannotWrite) {
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { writeSegment(in("none/s.mp4"), 0, 1); }),
              ::testing::StartsWith(in("none/s.mp4").native() + ": cannot be created: No such file"));
}

TEST_F(VideoSegmentTest, ReportsTheTimeSpentPerStep) {
  core::StepLedger steps;
  VideoSegmentWriter segment(in("s.mp4"), kSize, kFps, h264(18), 0, &steps);
  for (int k = 0; k < 5; ++k) segment.write({movingDisc(kSize, k)}, k);
  segment.finish();
  EXPECT_GT(steps.times()[core::Step::kConvert], 0);
  EXPECT_GT(steps.times()[core::Step::kEncode],
            kSanitized ? 0.0 : steps.times()[core::Step::kConvert]);  // which slows conversion
  EXPECT_GT(steps.times()[core::Step::kWrite], 0);
}

}  // namespace
}  // namespace poinsot::output
