// SPDX-License-Identifier: Apache-2.0
#include "image/png_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csetjmp>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/error.h"
#include "core/version.h"

namespace poinsot::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

Image noise(PixelSize size, int channels) {
  Image picture(size, channels);
  std::mt19937 random(11);
  for (auto& v : picture.pixels) v = static_cast<std::uint8_t>(random());
  return picture;
}

DeepImage deepNoise(PixelSize size, int channels) {
  DeepImage picture(size, channels);
  std::mt19937 random(12);
  for (auto& v : picture.pixels) v = static_cast<std::uint16_t>(random());
  return picture;
}

/// PNG that libpng itself writes, of a kind that encodePng() does not write.
struct Foreign {
  png_uint_32 width = 0, height = 0;
  int depth = 8;
  int type = PNG_COLOR_TYPE_GRAY;
  int interlace = PNG_INTERLACE_NONE;
  std::vector<png_color> palette = {};
  std::vector<png_byte> alphaOfPalette = {};
  std::vector<Bytes> rows = {};  ///< as in the file: 16-bit samples big-endian, small samples packed
};

void append(png_structp png, png_bytep data, std::size_t size) {
  auto* out = static_cast<Bytes*>(png_get_io_ptr(png));
  out->insert(out->end(), data, data + size);
}

Bytes written(Foreign f) {
  Bytes out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, append, nullptr);
  png_set_IHDR(png, info, f.width, f.height, f.depth, f.type, f.interlace, 0, 0);
  if (!f.palette.empty()) png_set_PLTE(png, info, f.palette.data(), static_cast<int>(f.palette.size()));
  if (!f.alphaOfPalette.empty())
    png_set_tRNS(png, info, f.alphaOfPalette.data(), static_cast<int>(f.alphaOfPalette.size()), nullptr);
  std::vector<png_bytep> pointers;
  for (Bytes& row : f.rows) pointers.push_back(row.data());
  png_set_rows(png, info, pointers.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

class PngFile : public ::testing::Test {
 protected:
  PngFile()
      : folder_(std::filesystem::path(::testing::TempDir()) / ("poinsot_png_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~PngFile() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path save(const std::string& name, const Bytes& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return folder_ / name;
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

std::string failure(std::span<const std::uint8_t> bytes, core::ErrorKind kind = core::ErrorKind::kIo) {
  try {
    decodePng(bytes, "some.png");
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  return "";
}

bool contains(const Bytes& bytes, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find(text) !=
         std::string_view::npos;
}

TEST(Png, RoundTripsEveryShape) {
  for (const PixelSize size : {PixelSize{1, 1}, {1, 9}, {9, 1}, {17, 13}, {320, 240}})
    for (const int channels : {3, 4}) {
      const Image picture = noise(size, channels);
      EXPECT_EQ(decodePng(encodePng(picture), "x"), picture)
          << size.width << "x" << size.height << "x" << channels;
    }
}

/// Content of a file as libpng reads it, with samples as stored.
struct Raw {
  int depth = 0, type = -1;
  Bytes samples;
};

Raw rawOf(Bytes bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::span<const std::uint8_t> rest(bytes);
  png_set_read_fn(png, &rest, [](png_structp from, png_bytep to, std::size_t size) {
    auto* left = static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(from));
    std::copy_n(left->begin(), size, to);
    *left = left->subspan(size);
  });
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  Raw raw{png_get_bit_depth(png, info), png_get_color_type(png, info), {}};
  for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y) {
    const png_bytep row = png_get_rows(png, info)[y];
    raw.samples.insert(raw.samples.end(), row, row + png_get_rowbytes(png, info));
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return raw;
}

TEST(Png, StoresADeepPictureWithSixteenBits) {
  for (const PixelSize size : {PixelSize{1, 1}, {9, 1}, {17, 13}, {320, 240}})
    for (const int channels : {3, 4}) {
      const DeepImage picture = deepNoise(size, channels);
      const Raw raw = rawOf(encodePng(picture));
      EXPECT_EQ(raw.depth, 16);
      EXPECT_EQ(raw.type, channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA);
      ASSERT_EQ(raw.samples.size(), 2 * picture.pixels.size());
      for (std::size_t i = 0; i < picture.pixels.size(); ++i)  // big-endian
        ASSERT_EQ(raw.samples[2 * i] << 8 | raw.samples[2 * i + 1], picture.pixels[i]) << i;
    }
}

TEST(Png, HasTheSameMetadataForADeepPicture) {
  const std::vector<PngText> texts = {{"Title", "Polhode"}};
  const Bytes deep = encodePng(deepNoise({4, 4}, 3), texts, 300), flat = encodePng(noise({4, 4}, 3), texts, 300);
  const auto untilPixels = [](const Bytes& bytes) {
    const std::string text(bytes.begin(), bytes.end());
    return text.substr(33, text.find("IDAT") - 37);  // from the end of IHDR
  };
  EXPECT_EQ(untilPixels(deep), untilPixels(flat));
  EXPECT_EQ(deep, encodePng(deepNoise({4, 4}, 3), texts, 300));
}

TEST(Png, StoresSrgbAndTextsButNoTime) {
  const Bytes bytes = encodePng(noise({4, 4}, 3), {{"Title", "Polhode"}, {"Comment", "ω̂ of the body"}});
  EXPECT_TRUE(contains(bytes, std::string_view("\0\0\0\x01sRGB\0", 9)));
  EXPECT_TRUE(contains(bytes, std::string("tEXtSoftware\0poinsot ", 21) + core::version()));
  EXPECT_TRUE(contains(bytes, std::string_view("tEXtTitle\0Polhode", 17)));
  EXPECT_TRUE(contains(bytes, "iTXtComment"));
  EXPECT_TRUE(contains(bytes, "ω̂ of the body"));
  EXPECT_FALSE(contains(bytes, "tIME"));
  EXPECT_EQ(bytes, encodePng(noise({4, 4}, 3), {{"Title", "Polhode"}, {"Comment", "ω̂ of the body"}}));
}

TEST(Png, RejectsInvalidTextKeys) {
  EXPECT_THROW(encodePng(noise({1, 1}, 3), {{"", "x"}}), std::logic_error);
  EXPECT_THROW(encodePng(noise({1, 1}, 3), {{std::string(80, 'k'), "x"}}), std::logic_error);
  EXPECT_THROW(encodePng(noise({1, 1}, 3), {{"clé", "x"}}), std::logic_error);
}

// 16-bit samples scale by 255/65535 and are rounded to nearest: 0x1234 = 4660 gives 18.13. 0x007f and 0x0082 lie
// on either side of a half.
TEST(Png, ReadsSixteenBitsRoundedToEight) {
  const Bytes bytes =
      written({.width = 2,
               .height = 1,
               .depth = 16,
               .type = PNG_COLOR_TYPE_RGB,
               .rows = {{0x12, 0x34, 0x00, 0x00, 0xff, 0xff, 0x80, 0x80, 0x00, 0x7f, 0x00, 0x82}}});
  const Image picture = decodePng(bytes, "x");
  EXPECT_EQ(picture.channels, 3);
  EXPECT_EQ(picture.pixels, (Bytes{18, 0, 255, 128, 0, 1}));
}

TEST(Png, ReadsGreyAndGreyWithAlpha) {
  EXPECT_EQ(decodePng(written({.width = 2, .height = 1, .rows = {{10, 200}}}), "x").pixels,
            (Bytes{10, 10, 10, 200, 200, 200}));
  const Image picture = decodePng(
      written({.width = 1, .height = 2, .type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {{10, 5}, {7, 255}}}), "x");
  EXPECT_EQ(picture.channels, 4);
  EXPECT_EQ(picture.pixels, (Bytes{10, 10, 10, 5, 7, 7, 7, 255}));
  // One bit a sample: 0 and 1 are black and white.
  EXPECT_EQ(decodePng(written({.width = 3, .height = 1, .depth = 1, .rows = {{0b10100000}}}), "x").pixels,
            (Bytes{255, 255, 255, 0, 0, 0, 255, 255, 255}));
}

TEST(Png, ReadsPaletteWithAndWithoutAlpha) {
  Foreign file{.width = 4,
               .height = 1,
               .depth = 2,
               .type = PNG_COLOR_TYPE_PALETTE,
               .palette = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}},
               .rows = {{0b00011000}}};  // entries 0 1 2 0
  EXPECT_EQ(decodePng(written(file), "x").pixels, (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3}));
  file.alphaOfPalette = {128};
  EXPECT_EQ(decodePng(written(file), "x").pixels, (Bytes{1, 2, 3, 128, 4, 5, 6, 255, 7, 8, 9, 255, 1, 2, 3, 128}));
}

TEST(Png, ReadsInterlacedFiles) {
  const Image picture = noise({13, 11}, 3);
  Foreign file{.width = 13, .height = 11, .type = PNG_COLOR_TYPE_RGB, .interlace = PNG_INTERLACE_ADAM7};
  for (int y = 0; y < 11; ++y) file.rows.emplace_back(picture.at(0, y), picture.at(0, y) + picture.rowBytes());
  EXPECT_EQ(decodePng(written(file), "x"), picture);
}

TEST(Png, RefusesEveryTruncation) {
  const Bytes bytes = encodePng(noise({6, 5}, 4), {{"Title", "cut"}});
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THAT(failure(std::span(bytes).first(length)), ::testing::StartsWith("some.png: not a readable PNG: "))
        << length;
}

// Every byte is covered by a checksum, or belongs to the signature or to a chunk's length and type. No change may
// pass unnoticed.
TEST(Png, RefusesEveryDamagedByte) {
  const Bytes good = encodePng(noise({6, 5}, 3));
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const int flip : {0x01, 0x20, 0x80}) {
      Bytes bad = good;
      bad[i] = static_cast<std::uint8_t>(bad[i] ^ flip);
      EXPECT_THROW(decodePng(bad, "x"), core::Error) << "byte " << i << " ^ " << flip;
    }
}

TEST(Png, RefusesGarbage) {
  std::mt19937 random(12);
  for (int i = 0; i < 500; ++i) {
    Bytes bytes = encodePng(Image({1, 1}, 3));
    bytes.resize(8 + random() % 100);
    for (std::size_t b = i % 2 == 0 ? 0 : 33; b < bytes.size(); ++b)
      bytes[b] = static_cast<std::uint8_t>(random());
    EXPECT_NE(failure(bytes), "");
  }
}

// Reading as stored reports the bits and the channels of the file. What libpng expands keeps its values.
TEST(Png, ReportsStoredChannelsAndBits) {
  const auto stored = [](const Foreign& f) { return decodePngAsStored(written(f), "x"); };
  const PngPicture grey = stored({.width = 2, .height = 1, .rows = {{7, 200}}});
  EXPECT_EQ(grey.stored.channels, 1);
  EXPECT_EQ(std::get<Image>(grey.picture).pixels, (Bytes{7, 7, 7, 200, 200, 200}));
  const PngPicture greyAlpha =
      stored({.width = 1, .height = 1, .type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {{7, 99}}});
  EXPECT_EQ(greyAlpha.stored.channels, 2);
  EXPECT_EQ(std::get<Image>(greyAlpha.picture).pixels, (Bytes{7, 7, 7, 99}));
  const Foreign palette{.width = 2,
                        .height = 1,
                        .type = PNG_COLOR_TYPE_PALETTE,
                        .palette = {{1, 2, 3}, {4, 5, 6}},
                        .rows = {{1, 0}}};
  EXPECT_EQ(stored(palette).stored, (PngStorage{3, true, false}));
  EXPECT_EQ(std::get<Image>(stored(palette).picture).pixels, (Bytes{4, 5, 6, 1, 2, 3}));
  Foreign clear = palette;
  clear.alphaOfPalette = {50};
  EXPECT_EQ(stored(clear).stored.channels, 4);
  const PngPicture deepGrey = stored({.width = 1, .height = 1, .depth = 16, .rows = {{0x12, 0x34}}});
  EXPECT_EQ(deepGrey.stored, (PngStorage{1, false, true}));
  EXPECT_EQ(std::get<DeepImage>(deepGrey.picture).pixels, (std::vector<std::uint16_t>{0x1234, 0x1234, 0x1234}));
  const DeepImage deep = deepNoise({5, 4}, 4);
  EXPECT_EQ(std::get<DeepImage>(decodePngAsStored(encodePng(deep), "x").picture), deep);
}

TEST(Png, ReportsStoredFormatOfOneBitAndInterlacedFiles) {
  Foreign bits{.width = 9, .height = 9, .depth = 1, .interlace = PNG_INTERLACE_ADAM7};
  for (int y = 0; y < 9; ++y) bits.rows.push_back({static_cast<std::uint8_t>(0xaa >> (y % 2)), 0x80});
  const PngPicture picture = decodePngAsStored(written(bits), "x");
  EXPECT_EQ(picture.stored.channels, 1);
  const Image& pixels = std::get<Image>(picture.picture);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_EQ(pixels.at(x, y)[0], (x + y) % 2 == 0 ? 255 : 0);
  EXPECT_EQ(pixels.at(8, 4)[2], 255);
}

/// Returns a file that declares a size and holds no pixels, so that a limit must act before any allocation.
Bytes declared(png_uint_32 width, png_uint_32 height) {
  Bytes out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_write_fn(png, &out, append, nullptr);
  png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, 0, 0, 0);
  png_write_info(png, info);
  const Bytes noPixels;
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), noPixels.data(), 0);
  png_destroy_write_struct(&png, &info);
  return out;
}

TEST(Png, HasLimitsOnItsSize) {
  EXPECT_THAT(failure(declared(kLargestPngSide, 4)), ::testing::HasSubstr("not a readable PNG"));
  EXPECT_THAT(failure(declared(kLargestPngSide + 1, 4), core::ErrorKind::kLimit),
              ::testing::HasSubstr("16385x4 pixels"));
  EXPECT_THAT(failure(declared(4, kLargestPngSide + 1), core::ErrorKind::kLimit),
              ::testing::HasSubstr("at most 16384"));
  EXPECT_THAT(failure(declared(8192, 8193), core::ErrorKind::kLimit), ::testing::HasSubstr("256 MiB"));
  EXPECT_THAT(failure(declared(0x7fffffff, 0x7fffffff), core::ErrorKind::kLimit), ::testing::HasSubstr("pixels"));
}

// Found by fuzzing: a file of 500 bytes made the reader allocate memory for a text of 1.4 GB.
TEST(Png, AllocatesNoMemoryForADeclaredLength) {
  Bytes bytes = encodePng(noise({4, 4}, 3), {{"Title", "Rolling"}});
  const std::string key = "tEXtTitle";
  const auto type = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
  ASSERT_NE(type, bytes.end());
  *(type - 4) = 0x54;
  const Bytes cut(bytes.begin(), type + 4);  // to where its contents would begin
  EXPECT_THAT(failure(cut), ::testing::HasSubstr("not a readable PNG: the file ends too early"));
  EXPECT_THAT(failure(bytes), ::testing::HasSubstr("not a readable PNG: the file ends too early"));
}

// Texts that a small file unpacks to are limited, and the picture is read all the same.
TEST(Png, LimitsTheTextsOfAFile) {
  const Image picture = noise({4, 4}, 3);
  const std::vector<PngText> many(1000, {"Title", "x"});
  const Bytes crowded = encodePng(picture, many);
  EXPECT_EQ(decodePng(crowded, "crowded.png"), picture);
  EXPECT_LE(textsOfWholePng(crowded).value().size(), 64u);
  const Bytes kept = encodePng(picture, {{"Title", std::string(1'000'000, 'x')}});
  EXPECT_EQ(textsOfWholePng(kept).value().at(1).value.size(), 1'000'000u);
  const Bytes large = encodePng(picture, {{"Title", std::string(2'000'000, 'x')}});
  EXPECT_EQ(decodePng(large, "large.png"), picture);
}

TEST_F(PngFile, ReadsBackFromDisk) {
  const Image picture = noise({12, 8}, 3);
  EXPECT_EQ(readPng(save("a.png", encodePng(picture))), picture);
}

TEST_F(PngFile, NamesThePathAndTheReasonInErrors) {
  const auto message = [](const std::filesystem::path& path) -> std::string {
    try {
      readPng(path);
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(folder() / "none.png"), (folder() / "none.png").native() + ": No such file or directory");
  EXPECT_EQ(message(folder()), folder().native() + ": it is a directory");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: it is not a regular file");
  ASSERT_EQ(::mkfifo((folder() / "fifo.png").c_str(), 0600), 0);
  EXPECT_THAT(message(folder() / "fifo.png"), ::testing::EndsWith("not a regular file"));  // and does not wait
  EXPECT_THAT(message(save("empty.png", {})), ::testing::HasSubstr("empty.png: not a readable PNG"));
}

TEST_F(PngFile, RecognisesItsOwnFiles) {
  EXPECT_TRUE(isOwnPng(save("own.png", encodePng(noise({3, 3}, 3)))));
  EXPECT_FALSE(isOwnPng(save("foreign.png", written({.width = 1, .height = 1, .rows = {{1}}}))));
  EXPECT_FALSE(isOwnPng(save("text.png", Bytes{'h', 'i'})));
  EXPECT_FALSE(isOwnPng(save("empty.png", {})));
  EXPECT_FALSE(isOwnPng(folder() / "none.png"));
  EXPECT_FALSE(isOwnPng(folder()));
  // A foreign file stays foreign, even if it has poinsot's words among its pixels.
  Bytes bytes = written({.width = 1, .height = 1, .rows = {{1}}});
  const std::string_view words("tEXtSoftware\0poinsot 9", 22);
  bytes.insert(bytes.end(), words.begin(), words.end());
  EXPECT_FALSE(isOwnPng(save("tail.png", bytes)));
  // A file that is cut before its mark is complete is not recognised, and no cut is read past its end.
  const Bytes own = encodePng(noise({3, 3}, 3));
  for (std::size_t n = 0; n < 70; ++n)
    EXPECT_FALSE(isOwnPng(save("cut.png", Bytes(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(n)))));
}

// 600 dpi are 600 / 0.0254 = 23622.05 pixels a metre: 0x5c46, in both directions, with unit 1 (PNG 1.2, 4.2.4.2).
TEST(Png, StoresPixelsPerInch) {
  const std::string chunk("\0\0\0\x09pHYs\0\0\x5c\x46\0\0\x5c\x46\x01", 17);
  EXPECT_TRUE(contains(encodePng(noise({3, 3}, 3), {}, 600), chunk));
  EXPECT_FALSE(contains(encodePng(noise({3, 3}, 3)), "pHYs"));
}

TEST(Png, ReportsTheVersionOfLibpng) { EXPECT_THAT(libpngVersion(), ::testing::StartsWith("1.6.")); }

}  // namespace
}  // namespace poinsot::image
