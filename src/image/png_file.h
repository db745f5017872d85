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

/// Reports whether a file's name ends in ".png", in any case.
bool isPngName(const std::filesystem::path& file);

/// Text chunk. The key has 1 to 79 printable ASCII characters; the value is UTF-8 without NUL.
struct PngText {
  std::string key;
  std::string value;
};

/// Limits of PNG files that are read: side in pixels, and decoded size in bytes (of RGBA).
inline constexpr std::uint32_t kLargestPngSide = 16384;
inline constexpr std::uint64_t kLargestPngBytes = std::uint64_t{256} << 20;

/// Returns a PNG file: RGB or RGBA of 8 or 16 bits, an sRGB chunk, "Software: poinsot VERSION", then `texts`. The
/// file has no time, so equal pixels give equal bytes (for one version of libpng and ISA-L).
/// @param dpi  pixels per inch for a pHYs chunk, which gives the picture a size in print; 0 for no such chunk
std::vector<std::uint8_t> encodePng(const Image& picture, const std::vector<PngText>& texts = {}, double dpi = 0);
std::vector<std::uint8_t> encodePng(const DeepImage& picture, const std::vector<PngText>& texts = {},
                                    double dpi = 0);

/// Decodes a PNG file of any kind (1 to 16 bit, grey, palette, alpha, interlaced) to 8-bit RGB, or RGBA if the
/// file has transparency. Samples are taken as sRGB: gamma and colour profiles are not applied.
/// @param name  stands for the bytes in messages
/// @throws core::Error(kIo) if damaged, truncated or no PNG; core::Error(kLimit) if larger than the limits above.
Image decodePng(std::span<const std::uint8_t> bytes, std::string_view name);

/// Storage format of a PNG file's pixels, which a lossless optimiser may change.
struct PngStorage {
  int channels = 3;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; 3 or 4 for a palette, as its colours have
  bool palette = false;
  bool deep = false;  ///< 16 bits a sample; otherwise 8 or fewer
  friend bool operator==(const PngStorage&, const PngStorage&) = default;
};

/// RGB or RGBA picture with the depth of its file: 16 bits, or 8 bits if the file has 8 or fewer.
struct PngPicture {
  AnyImage picture;
  PngStorage stored;
  ColorTag color;
};

/// Decodes a PNG file like decodePng(), but keeps 16-bit samples. @throws as decodePng().
PngPicture decodePngAsStored(std::span<const std::uint8_t> bytes, std::string_view name);

/// Reports whether a file is an animated PNG (APNG), by its acTL chunk instead of its name. False if the file
/// cannot be read.
bool isAnimatedPng(const std::filesystem::path& path);

/// Reads and decodes a file.
/// @throws as decodePng(); core::Error(kIo) also if the file cannot be read or is no regular file.
PngPicture readPngAsStored(const std::filesystem::path& path);
Image readPng(const std::filesystem::path& path);

/// Returns the texts of an intact PNG file: every checksum right, every pixel present. nullopt if the file is
/// damaged, truncated, no PNG or unreadable.
std::optional<std::vector<PngText>> textsOfWholePng(const std::filesystem::path& path);
std::optional<std::vector<PngText>> textsOfWholePng(std::span<const std::uint8_t> bytes);

/// Reports whether encodePng() wrote the file and, unless `key` is empty, the file has a text of that key. False
/// if the file cannot be read; never throws for content.
bool isOwnPng(const std::filesystem::path& path, std::string_view key = {});

/// Returns the version of the libpng that was loaded at run time, such as "1.6.39".
std::string libpngVersion();

}  // namespace poinsot::image
