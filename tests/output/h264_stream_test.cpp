// SPDX-License-Identifier: Apache-2.0
// Streams are put together by hand from ITU-T H.264: start codes (annex B), unit types (table 7-1), SEI messages
// (7.3.2.3.1).
#include "output/h264_stream.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace poinsot::output {
namespace {

using Bytes = std::vector<std::uint8_t>;

const Bytes kX264 = {0xdc, 0x45, 0xe9, 0xbd, 0xe6, 0xd9, 0x48, 0xb7,
                     0x96, 0x2c, 0xd8, 0x20, 0xd9, 0x23, 0xee, 0xef};

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns an SEI unit with one user data message, which has a UUID and a text.
Bytes note(const Bytes& uuid, const std::string& text) {
  Bytes unit = {0, 0, 1, 6, 5};
  std::size_t size = 16 + text.size() + 1;
  for (; size >= 255; size -= 255) unit.push_back(255);
  unit.push_back(static_cast<std::uint8_t>(size));
  return unit + uuid + Bytes(text.begin(), text.end()) + Bytes{0, 0x80};
}

const Bytes kParameters = {0, 0, 0, 1, 0x67, 1, 2, 3, 0, 0, 0, 1, 0x68, 4, 5};
const Bytes kPicture = {0, 0, 1, 0x65, 9, 8, 0, 0, 3, 1, 7};

Bytes cleaned(Bytes stream, std::string* text = nullptr) {
  stream.resize(removeEncoderNote(stream, text));
  return stream;
}

TEST(EncoderNote, IsRemovedFromTheStream) {
  for (const std::string& text : {std::string("x264 - core 164"), std::string(700, 'o'), std::string(238, 'p')}) {
    std::string found;
    EXPECT_EQ(cleaned(kParameters + note(kX264, text) + kPicture, &found), kParameters + kPicture);
    EXPECT_EQ(found, text);
    EXPECT_EQ(cleaned(kParameters + Bytes{0} + note(kX264, text) + kPicture), kParameters + kPicture);
    EXPECT_EQ(cleaned(note(kX264, text)), Bytes{});
    EXPECT_EQ(cleaned(note(kX264, text) + note(kX264, text) + kPicture), kPicture);
  }
}

TEST(EncoderNote, IsRemovedWithoutChangingOtherUnits) {
  Bytes otherUuid = kX264;
  otherUuid[15] ^= 1;
  const Bytes pictureTiming = {0, 0, 1, 6, 1, 2, 7, 7, 0x80};
  const Bytes uuidInAPicture = Bytes{0, 0, 1, 0x65, 5, 40} + kX264 + Bytes{1, 2, 3};
  for (const Bytes& unit : {note(otherUuid, "others"), pictureTiming, uuidInAPicture, kPicture, kParameters}) {
    EXPECT_EQ(cleaned(unit), unit);
    EXPECT_EQ(cleaned(kParameters + unit + kPicture), kParameters + unit + kPicture);
  }
}

TEST(EncoderNote, IsSearchedSafelyInDamagedStreams) {
  const Bytes whole = kParameters + note(kX264, "x264") + kPicture;
  for (std::size_t n = 0; n <= whole.size(); ++n) {
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n));
    EXPECT_LE(removeEncoderNote(cut), n);
  }
  std::mt19937 random(13);
  for (int i = 0; i < 2000; ++i) {
    Bytes noise(random() % 60);
    for (auto& b : noise) b = static_cast<std::uint8_t>(random() % 8);  // rich in start codes and SEI
    EXPECT_LE(removeEncoderNote(noise), noise.size());
  }
}

}  // namespace
}  // namespace poinsot::output
