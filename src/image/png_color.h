// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/abi.h"

namespace poinsot::image {

/// Chunks of a PNG file that describe the colour space of its samples.
struct PngColorChunks {
  std::optional<std::array<std::uint8_t, 4>> cicp;  ///< primaries, transfer, matrix, full range: ITU-T H.273
  std::string profileName;                          ///< name in iCCP; empty without one
  std::span<const std::uint8_t> profile;            ///< bytes of the iCCP profile, decompressed
  bool isSrgb = false;                          ///< has an sRGB chunk, or a profile that libpng knows as sRGB's
  std::optional<double> gamma;                  ///< gAMA: exponent of encoding, 0.45455 for sRGB
  std::optional<std::array<int, 8>> primaries;  ///< cHRM: x and y of white, red, green, blue, in 1e-5
};

/// Colour space that a file declares for its samples.
struct ColorTag {
  std::string name = "sRGB";  ///< for people: "Display P3 (cICP)"
  std::string identity = {};  ///< equal for equal colour spaces; empty for sRGB
  friend bool operator==(const ColorTag& a, const ColorTag& b) { return a.identity == b.identity; }
};

/// Returns the colour space that a reader must apply: that of cICP, otherwise iCCP, otherwise sRGB, otherwise gAMA
/// and cHRM. Files without any of these chunks are sRGB.
/// Source: W3C, Portable Network Graphics (PNG) Specification, third edition, 2025, section 4.3.
ColorTag colorTagOf(const PngColorChunks& chunks);

}  // namespace poinsot::image
