// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/abi.h"

namespace poinsot::image {

/// Chunks of a PNG file about the colours that its samples stand for.
struct PngColorChunks {
  std::optional<std::array<std::uint8_t, 4>> cicp;  ///< primaries, transfer, matrix, full range: ITU-T H.273
  std::string profileName;                          ///< iCCP; empty without one
  std::span<const std::uint8_t> profile;            ///< its bytes, unpacked
  bool isSrgb = false;                              ///< sRGB, or a profile that libpng knows as sRGB's
  std::optional<double> gamma;                      ///< gAMA: exponent of encoding, 0.45455 for sRGB
  std::optional<std::array<int, 8>> primaries;      ///< cHRM: x and y of white, red, green, blue, in 1e-5
};

/// A colour space that samples are tagged with.
struct ColorTag {
  std::string name = "sRGB";  ///< for people: "Display P3 (cICP)"
  std::string identity = {};  ///< equal for equal colour spaces; empty for sRGB
  friend bool operator==(const ColorTag& a, const ColorTag& b) { return a.identity == b.identity; }
};

/// The tag that a reader obeys: cICP before iCCP before sRGB before gAMA and cHRM. Files without any are sRGB.
/// Source: W3C, Portable Network Graphics (PNG) Specification, third edition, 2025, section 4.3.
ColorTag colorTagOf(const PngColorChunks& chunks);

}  // namespace poinsot::image
