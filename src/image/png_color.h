// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/abi.h"

namespace poinsot::image {

/// Content of those chunks of a PNG file that describe the colour space of its samples.
struct PngColorChunks {
  /// cICP: codes of primaries, transfer function, matrix and full range (ITU-T H.273).
  std::optional<std::array<std::uint8_t, 4>> cicp;
  std::string profileName;                ///< name of the iCCP profile; empty if there is none
  std::span<const std::uint8_t> profile;  ///< decompressed bytes of the iCCP profile
  /// Whether the file has an sRGB chunk, or a profile that libpng recognises as sRGB.
  bool isSrgb = false;
  std::optional<double> gamma;                  ///< gAMA: exponent of the encoding, such as 0.45455 for sRGB
  std::optional<std::array<int, 8>> primaries;  ///< cHRM: x and y of white, red, green and blue, times 100000
};

/// Colour space that a file declares for its samples.
struct ColorTag {
  std::string name = "sRGB";  ///< name for people, such as "Display P3 (cICP)"
  std::string identity = {};  ///< text that is equal only for equal colour spaces; empty for sRGB
  friend bool operator==(const ColorTag& a, const ColorTag& b) { return a.identity == b.identity; }
};

/// Returns the colour space that readers must use for a file. The first of these chunks that is present decides:
/// cICP, iCCP, sRGB, gAMA with cHRM. A file without these chunks is sRGB.
/// Source: W3C, Portable Network Graphics (PNG) Specification, third edition, 2025, section 4.3.
ColorTag colorTagOf(const PngColorChunks& chunks);

}  // namespace poinsot::image
