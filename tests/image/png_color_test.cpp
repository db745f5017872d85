// SPDX-License-Identifier: Apache-2.0
// Expected tags come from the PNG specification (third edition, 4.3 and 11.3.2) and ITU-T H.273.
#include "image/png_color.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.h"
#include "image/png_file.h"
#include "support/raw_png.h"

namespace poinsot::image {
namespace {

Bytes bigEndian(std::uint32_t v) {
  return {static_cast<std::uint8_t>(v >> 24), static_cast<std::uint8_t>(v >> 16),
          static_cast<std::uint8_t>(v >> 8), static_cast<std::uint8_t>(v)};
}

Bytes chunk(const std::string& type, const Bytes& data) { return pngChunk(type, data); }

/// Returns a PNG of one grey pixel, with some chunks before the pixel.
Bytes png(const std::vector<Bytes>& chunks) { return pngBytes({.colorType = 0, .chunks = chunks}, {77}); }

std::string tagOf(const std::vector<Bytes>& chunks) { return decodePngAsStored(png(chunks), "x").color.name; }

Bytes gamma(std::uint32_t v) { return chunk("gAMA", bigEndian(v)); }

Bytes primaries(std::initializer_list<std::uint32_t> values) {
  Bytes data;
  for (const std::uint32_t v : values)
    for (const std::uint8_t b : bigEndian(v)) data.push_back(b);
  return chunk("cHRM", data);
}

const Bytes kSrgb = chunk("sRGB", {0});

TEST(PngColor, NamesTheColourTagThatTakesPrecedence) {
  EXPECT_EQ(tagOf({}), "sRGB");
  EXPECT_EQ(tagOf({kSrgb}), "sRGB");
  EXPECT_EQ(tagOf({gamma(45455)}), "sRGB");
  EXPECT_EQ(tagOf({gamma(45455), primaries({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})}), "sRGB");
  EXPECT_EQ(tagOf({gamma(100000)}), "gamma 1 (gAMA)");
  EXPECT_EQ(tagOf({gamma(55556)}), "gamma 1.8 (gAMA)");
  // Display P3 has the primaries of SMPTE EG 432-1 and the white point D65.
  EXPECT_EQ(tagOf({primaries({31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000})}),
            "primaries of its own (cHRM)");
  EXPECT_EQ(tagOf({chunk("cICP", {1, 13, 0, 1})}), "sRGB");
  EXPECT_EQ(tagOf({chunk("cICP", {12, 13, 0, 1})}), "Display P3 (cICP)");
  EXPECT_EQ(tagOf({chunk("cICP", {9, 16, 0, 1})}), "BT.2100 PQ (cICP)");
  EXPECT_EQ(tagOf({chunk("cICP", {12, 13, 0, 0})}), "12-13-0-0 (cICP)");  // narrow range
  EXPECT_EQ(tagOf({chunk("cICP", {12, 13, 0, 1}), kSrgb}), "Display P3 (cICP)");
}

TEST(PngColor, EqualTagsAreEqual) {
  const auto tag = [](const std::vector<Bytes>& chunks) { return decodePngAsStored(png(chunks), "x").color; };
  EXPECT_EQ(tag({}), tag({kSrgb}));
  EXPECT_EQ(tag({gamma(100000)}), tag({gamma(100000)}));
  EXPECT_FALSE(tag({gamma(100000)}) == tag({gamma(55556)}));
  EXPECT_FALSE(tag({chunk("cICP", {12, 13, 0, 1})}) == tag({}));
}

// An animated PNG has a chunk acTL before the pixels.
TEST(PngColor, RecognisesAnAnimationByItsContent) {
  const auto path = std::filesystem::path(::testing::TempDir()) / ("poinsot_actl_" + std::to_string(::getpid()));
  const auto isAnimated = [&](const Bytes& bytes) {
    saveBytes(path, bytes);
    return isAnimatedPng(path);
  };
  const Bytes acTL = chunk("acTL", {0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_TRUE(isAnimated(png({acTL})));
  EXPECT_TRUE(isAnimated(png({chunk("zzZz", Bytes(100000)), acTL})));
  EXPECT_FALSE(isAnimated(png({})));
  EXPECT_FALSE(isAnimated({'a', 'c', 'T', 'L'}));
  std::filesystem::remove(path);
  EXPECT_FALSE(isAnimatedPng(path));
}

std::string failureOf(std::string_view text) {
  try {
    decodePng({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "some.png");
  } catch (const core::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Png, DescribesFilesThatAreNotPictures) {
  using ::testing::HasSubstr;
  EXPECT_THAT(
      failureOf("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12345\n"),
      HasSubstr(
          "some.png: not a readable PNG: the file is a Git LFS pointer; get the picture with `git lfs pull`"));
  EXPECT_THAT(failureOf(""), HasSubstr("the file is empty"));
  EXPECT_THAT(failureOf("hello"), HasSubstr("Not a PNG file"));
  EXPECT_THAT(failureOf("\x89PN"), HasSubstr("the file ends too early"));
}

}  // namespace
}  // namespace poinsot::image
