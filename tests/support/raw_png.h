// SPDX-License-Identifier: Apache-2.0
// Writes PNG files of every kind, chunk by chunk from the specification and without the program's own code.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

using Bytes = std::vector<std::uint8_t>;

Bytes pngChunk(const std::string& type, const Bytes& data);

struct RawPng {
  std::uint32_t width = 1, height = 1;
  std::uint8_t depth = 8;
  std::uint8_t colorType = 2;      ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  std::vector<Bytes> chunks = {};  ///< between IHDR and the pixels
};

/// Returns a PNG file.
/// @param samples  as stored: rows from the top, without filter bytes
Bytes pngBytes(const RawPng& file, const Bytes& samples);

/// Returns an animated PNG that shows each picture for its delay.
/// @param defaultPicture  shown by viewers without support for animation; if empty, the first picture is shown
/// @pre as many delays as pictures
Bytes apngBytes(const RawPng& file, const std::vector<Bytes>& pictures,
                const std::vector<std::uint16_t>& delays_ms, const Bytes& defaultPicture = {});

/// Writes a file, and creates the folders above it.
void saveBytes(const std::filesystem::path& file, const Bytes& bytes);

}  // namespace poinsot
