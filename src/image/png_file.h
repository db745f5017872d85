// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "image/png_color.h"

namespace poinsot::image {

/// Reports whether a file's name ends in ".png", in upper or lower case.
bool isPngName(const std::filesystem::path& file);

/// Text chunk of a PNG file. The key has 1 to 79 printable ASCII characters. The value is UTF-8 without NUL.
struct PngText {
  std::string key;
  std::string value;
};

/// Limits for PNG files to be read: longest side in pixels, and largest decoded size in bytes with 4 channels.
inline constexpr std::uint32_t kLargestPngSide = 16384;
inline constexpr std::uint64_t kLargestPngBytes = std::uint64_t{256} << 20;

/// Returns a picture as a PNG file: RGB or RGBA with 8 or 16 bits per sample, an sRGB chunk, the text "Software:
/// poinsot VERSION", then `texts`. The file contains no date. Equal pixels therefore give equal bytes with the
/// same versions of libpng and ISA-L.
/// @param dpi  pixels per inch, which give the picture a size in print (pHYs chunk); 0 for no such chunk
std::vector<std::uint8_t> encodePng(const Image& picture, const std::vector<PngText>& texts = {}, double dpi = 0);
std::vector<std::uint8_t> encodePng(const DeepImage& picture, const std::vector<PngText>& texts = {},
                                    double dpi = 0);

/// Decodes a PNG file to 8-bit RGB, or to RGBA if the file has transparency. All kinds of PNG are read: 1 to 16
/// bits, grey, palette, alpha, interlaced. Samples are assumed to be sRGB; gamma and colour profiles are ignored.
/// @param name  name of the file in error messages
/// @throws core::Error(kIo) if damaged, truncated or no PNG; core::Error(kLimit) if larger than the limits above.
Image decodePng(std::span<const std::uint8_t> bytes, std::string_view name);

/// Format in which a PNG file stores its pixels. A lossless optimiser may change the format.
struct PngStorage {
  /// 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA. A file with a palette counts as RGB or RGBA.
  int channels = 3;
  bool palette = false;
  bool deep = false;  ///< true for 16 bits per sample, false for 8 or fewer
  friend bool operator==(const PngStorage&, const PngStorage&) = default;
};

/// RGB or RGBA picture with 16 bits per sample if its file has 16 bits; otherwise with 8 bits.
struct PngPicture {
  AnyImage picture;
  PngStorage stored;
  ColorTag color;
};

/// Decodes a PNG file like decodePng(), but keeps 16-bit samples. @throws as decodePng().
PngPicture decodePngAsStored(std::span<const std::uint8_t> bytes, std::string_view name);

/// Reports whether a file is an animated PNG (APNG). The acTL chunk decides. False if unreadable.
bool isAnimatedPng(const std::filesystem::path& path);

/// Reads and decodes a file.
/// @throws as decodePng(); core::Error(kIo) also if the file cannot be read or is not a regular file.
PngPicture readPngAsStored(const std::filesystem::path& path);
Image readPng(const std::filesystem::path& path);

/// Returns the text chunks of an intact PNG file. Returns nullopt if a checksum is wrong or pixels are missing, or
/// if the file is not a PNG or cannot be read.
std::optional<std::vector<PngText>> textsOfWholePng(const std::filesystem::path& path);
std::optional<std::vector<PngText>> textsOfWholePng(std::span<const std::uint8_t> bytes);

/// Reports whether a file was written by encodePng(). If `key` is not empty, the file must also have a text with
/// that key. Returns false if the file cannot be read. Never throws because of the file's content.
bool isOwnPng(const std::filesystem::path& path, std::string_view key = {});

/// Returns the version of the libpng that was loaded at run time, such as "1.6.39".
std::string libpngVersion();

}  // namespace poinsot::image
