// SPDX-License-Identifier: Apache-2.0
// Checks that a film with any changed byte is never taken for the film that was written. The test has the original
// and changes the bytes itself; sha256sum computes the digest again.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "decoded_film.h"
#include "output/ffmpeg_encoder.h"
#include "output/film.h"
#include "output/film_format.h"
#include "output/video_segment.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

constexpr const char* kOrigin = "frames 0-5 of scene sha256 1f; job sha256 2e; ";

class FilmDamage : public FolderTest, public testing::WithParamInterface<FilmContainer> {
 protected:
  void SetUp() override {
    if (const char* missing = missingEncoder(codecsOf(GetParam()).front()))
      GTEST_SKIP() << "no encoder " << missing;
    constexpr image::PixelSize kSize{48, 32};
    const FilmFormat format{GetParam(), codecsOf(GetParam()).front()};
    std::vector<std::filesystem::path> segments;
    for (int first = 0; first < 6; first += 3) {
      segments.push_back(in(fmt::format("segment_{}", first)));
      VideoSegmentWriter segment(segments.back(), kSize, {25, 1}, format, first);
      for (int k = first; k < first + 3; ++k) segment.write({movingDisc(kSize, k)}, k);
      segment.finish();
    }
    film_ = in("film." + std::string(nameOf(GetParam())));
    joinSegments(segments, film_, {GetParam(), {25, 1}}, {"A disc", "It moves.", kOrigin, "a test"});
    const Bytes bytes = content(film_);
    whole_.assign(bytes.begin(), bytes.end());
  }

  FilmState stateOf(const std::string& bytes) const {
    save(film_.filename(), bytes);
    return filmState(film_, kOrigin);
  }

  std::filesystem::path film_;
  std::string whole_;
};

TEST_P(FilmDamage, IsNotReportedForAnUnchangedFilm) {
  EXPECT_EQ(filmState(film_, kOrigin), FilmState::kWhole);
  EXPECT_TRUE(isWholeFilm(film_));
  EXPECT_EQ(filmState(film_, "frames 0-6 of scene sha256 1f; job sha256 2e; "), FilmState::kOther);
  EXPECT_EQ(filmState(in("none.mp4"), kOrigin), FilmState::kOther);
}

/// Returns the CRC-32 of a PNG chunk, bit by bit (PNG, annex D).
std::uint32_t pngCheckSum(std::string_view bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char byte : bytes) {
    sum ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? sum >> 1 ^ 0xedb88320 : sum >> 1;
  }
  return ~sum;
}

constexpr std::string_view kWord = "film sha256 ";

std::string sealIn(const std::string& film) { return film.substr(film.find(kWord), kWord.size() + 64); }

TEST_P(FilmDamage, CanBeDetectedWithSha256sum) {
  const auto at = whole_.find(kWord) + kWord.size();
  ASSERT_LT(at, whole_.size());
  const std::string digits = whole_.substr(at, 64);
  std::string blank = whole_;
  blank.replace(at, 64, std::string(64, '0'));
  if (GetParam() == FilmContainer::kApng) {
    const auto chunk = blank.rfind("iTXt", at), end = at + 64;
    const std::uint32_t sum = pngCheckSum(std::string_view(blank).substr(chunk, end - chunk));
    for (int i = 0; i < 4; ++i) blank[end + i] = static_cast<char>(sum >> (24 - 8 * i));
  }
  save("blank", blank);
  const std::string check =
      fmt::format("cd '{}' && echo '{}  blank' | sha256sum -c --status", in("").native(), digits);
  EXPECT_EQ(std::system(check.c_str()), 0);
}

/// Random damages of the kinds that happen to disks, to copies and through careless writers.
class Damages {
 public:
  explicit Damages(std::string whole) : whole_(std::move(whole)) {}

  std::string next() {
    std::string bytes;
    do bytes = damaged();
    while (bytes == whole_);
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }
  char noise() { return static_cast<char>(below(256)); }

  std::string damaged() {
    std::string bytes = whole_;
    const std::size_t at = below(bytes.size()), count = 1 + below(bytes.size() - at);
    switch (below(7)) {
      case 0:  // bytes flipped
        for (std::size_t i = 1 + below(8); i > 0; --i) bytes[below(bytes.size())] = noise();
        return bytes;
      case 1:  // a block of zeros, as after a loss of power
        return bytes.replace(at, count, count, '\0');
      case 2:
        return bytes.substr(0, at);
      case 3:  // appended to
        for (std::size_t i = 1 + below(512); i > 0; --i) bytes += at % 2 == 0 ? '\0' : noise();
        return bytes;
      case 4: {  // two blocks swapped
        const std::size_t size = 1 + below(bytes.size() / 2), from = below(bytes.size() / 2 - size + 1),
                          to = bytes.size() / 2 + below(bytes.size() / 2 - size + 1);
        std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(from),
                         bytes.begin() + static_cast<std::ptrdiff_t>(from + size),
                         bytes.begin() + static_cast<std::ptrdiff_t>(to));
        return bytes;
      }
      case 5:  // a block of noise
        for (std::size_t i = at; i < at + count; ++i) bytes[i] = noise();
        return bytes;
      default:  // everything becomes noise
        for (char& byte : bytes) byte = noise();
        return bytes;
    }
  }

  std::string whole_;
  std::mt19937 random_{33};
};

TEST_P(FilmDamage, IsNoticedAfterRandomChanges) {
  constexpr int kDamages = 200;
  Damages damages(whole_);
  int noticed = 0, ours = 0;
  for (int i = 0; i < kDamages; ++i) {
    const std::string damaged = damages.next();
    noticed += stateOf(damaged) != FilmState::kWhole && !isWholeFilm(film_) ? 1 : 0;
    const bool hasMark = damaged.find("poinsot 0") != damaged.npos,
               hasSeal = damaged.find(sealIn(whole_)) != damaged.npos;
    const bool own = isOwnFilm(film_);
    EXPECT_TRUE(hasMark != hasSeal || own == hasMark) << "damage " << i;
    ours += own ? 1 : 0;
  }
  EXPECT_EQ(noticed, kDamages);
  EXPECT_GT(ours, kDamages / 2);  // measured 130 to 173
  EXPECT_EQ(stateOf(whole_), FilmState::kWhole);
  RecordProperty("ours", ours);
}

// Changes one bit of every byte, or of every n-th byte of a larger film.
TEST_P(FilmDamage, IsNoticedInEveryByte) {
  constexpr std::size_t kMost = 12'000;
  const std::size_t step = 1 + whole_.size() / kMost;
  std::fstream file(film_, std::ios::binary | std::ios::in | std::ios::out);
  const auto put = [&](std::size_t at, int byte) {
    file.seekp(static_cast<std::streamoff>(at)).put(static_cast<char>(byte)).flush();
  };
  for (std::size_t i = 0; i < whole_.size(); i += step) {
    put(i, whole_[i] ^ 1 << i % 8);
    ASSERT_NE(filmState(film_, kOrigin), FilmState::kWhole) << "byte " << i << " of " << whole_.size();
    put(i, whole_[i]);
  }
  EXPECT_EQ(filmState(film_, kOrigin), FilmState::kWhole);
  RecordProperty("bytes", static_cast<int>(whole_.size()));
}

// The film lacks its end only. The mark stands before the pictures, so that poinsot may replace the film.
TEST_P(FilmDamage, TruncatedFilmIsStillRecognisedAsOurs) {
  for (const double share : {0.5, 0.8, 0.99}) {
    const auto size = static_cast<double>(whole_.size());
    EXPECT_NE(stateOf(whole_.substr(0, static_cast<std::size_t>(share * size))), FilmState::kWhole);
    EXPECT_TRUE(isOwnFilm(film_)) << share;
  }
}

// FFmpeg keeps the texts of a film that it copies, such as a film to which somebody added sound.
TEST_P(FilmDamage, CopiesByFfmpegAreNotRecognisedAsOurs) {
  if (isMadeWhole(GetParam())) GTEST_SKIP() << "copies of this format do not name their writer";
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
  const auto copy = in("copy" + film_.extension().string());
  const std::string command =
      fmt::format("ffmpeg -v error -i '{}' -c copy -metadata title=mine '{}'", film_.native(), copy.native());
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Bytes bytes = content(copy);
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()), testing::HasSubstr(sealIn(whole_)));
  EXPECT_FALSE(isOwnFilm(copy));
}

// A title is the user's. A digest of a film in a title is not taken for a seal, and is left unchanged.
TEST_P(FilmDamage, IgnoresDigestsInATitle) {
  const std::string words = "film sha256 " + std::string(64, '0');
  joinSegments({in("segment_0")}, film_, {GetParam(), {25, 1}}, {words, words + " again", kOrigin, "a test"});
  EXPECT_EQ(filmState(film_, kOrigin), FilmState::kWhole);
  const Bytes bytes = content(film_);
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()), testing::HasSubstr(words));
}

// A work folder, which may come from anyone, names the origin. Containers end texts at a zero byte.
TEST_P(FilmDamage, OriginWithAZeroByteIsKeptOrRejected) {
  const std::string origin("job \0 sha256; ", 14);
  const std::string refusal = messageOf(core::ErrorKind::kIo, [&] {
    joinSegments({in("segment_0")}, film_, {GetParam(), {25, 1}}, {"", "", origin, "a test"});
  });
  if (refusal.empty())
    EXPECT_EQ(filmState(film_, origin), FilmState::kWhole);
  else
    EXPECT_THAT(refusal, testing::EndsWith("cannot store the text of the film's origin in the file"));
}

INSTANTIATE_TEST_SUITE_P(All, FilmDamage, testing::ValuesIn(filmContainers().begin(), filmContainers().end()),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

}  // namespace
}  // namespace poinsot::output
