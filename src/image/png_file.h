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

/// Whether its name says that a file is a PNG: ".png" in any case.
bool isPngName(const std::filesystem::path& file);

/// One text chunk. Key: 1 to 79 printable ASCII characters; value: UTF-8 without NUL.
struct PngText {
  std::string key;
  std::string value;
};

/// Largest side in pixels and largest decoded picture in bytes (of RGBA) that is read.
inline constexpr std::uint32_t kLargestPngSide = 16384;
inline constexpr std::uint64_t kLargestPngBytes = std::uint64_t{256} << 20;

/// A PNG file: RGB or RGBA of 8 or 16 bits, sRGB chunk, "Software: poinsot VERSION", then `texts`; no time, so
/// that the same pixels give the same bytes (for one version of libpng and ISA-L). With `dpi` > 0 a pHYs chunk
/// says that many pixels to the inch, so that the picture has a size in print.
std::vector<std::uint8_t> encodePng(const Image& picture, const std::vector<PngText>& texts = {}, double dpi = 0);
std::vector<std::uint8_t> encodePng(const DeepImage& picture, const std::vector<PngText>& texts = {},
                                    double dpi = 0);

/// The picture of a PNG file of any kind (1 to 16 bit, grey, palette, alpha, interlaced) as 8-bit RGB, or RGBA
/// where the file has transparency. Samples are taken as sRGB: gamma and colour profiles are not applied.
/// @param name stands for the bytes in messages.
/// @throws core::Error(kIo) if damaged, truncated or no PNG; core::Error(kLimit) if larger than the limits above.
Image decodePng(std::span<const std::uint8_t> bytes, std::string_view name);

/// How a PNG file stores its pixels: what a lossless optimiser may change.
struct PngStorage {
  int channels = 3;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; for a palette, its colours' 3 or 4
  bool palette = false;
  bool deep = false;  ///< 16 bits a sample; else 8 or fewer
  friend bool operator==(const PngStorage&, const PngStorage&) = default;
};

/// A picture with the bits that its file has: 8 (of fewer, too) or 16.
struct PngPicture {
  AnyImage picture;  ///< RGB or RGBA
  PngStorage stored;
  ColorTag color;
};

/// @throws as decodePng.
PngPicture decodePngAsStored(std::span<const std::uint8_t> bytes, std::string_view name);

/// Whether the file is an animated PNG (APNG), by its acTL chunk and not by its name. False for a file that cannot
/// be read.
bool isAnimatedPng(const std::filesystem::path& path);

/// Reads a file. @throws as decodePng; core::Error(kIo) also if the file cannot be read or is no regular file.
PngPicture readPngAsStored(const std::filesystem::path& path);
Image readPng(const std::filesystem::path& path);

/// The texts of a PNG file that is whole: every checksum right, every pixel there. Nothing of one that is damaged,
/// truncated, no PNG or cannot be read.
std::optional<std::vector<PngText>> textsOfWholePng(const std::filesystem::path& path);
/// Of its bytes.
std::optional<std::vector<PngText>> textsOfWholePng(std::span<const std::uint8_t> bytes);

/// Whether the file is a PNG written by encodePng; with a key, one that has a text of that key. False for a file
/// that cannot be read; never throws for content.
bool isOwnPng(const std::filesystem::path& path, std::string_view key = {});

/// "1.6.39", of the library loaded at run time.
std::string libpngVersion();

}  // namespace poinsot::image
