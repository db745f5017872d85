// SPDX-License-Identifier: Apache-2.0
// PNG files of every kind, written chunk by chunk after the specification, so that they owe nothing to the
// program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

using Bytes = std::vector<std::uint8_t>;

/// A chunk with its length and checksum.
Bytes pngChunk(const std::string& type, const Bytes& data);

/// Properties of a file besides its pixels.
struct RawPng {
  std::uint32_t width = 1, height = 1;
  std::uint8_t depth = 8;
  std::uint8_t colorType = 2;      ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  std::vector<Bytes> chunks = {};  ///< between IHDR and the pixels
};

/// A file of samples as they are stored: rows from the top, without filter bytes.
Bytes pngBytes(const RawPng& file, const Bytes& samples);

/// An animation of such pictures, each shown for so many milliseconds. @pre as many delays as pictures.
/// @param defaultPicture  shown by viewers that know no animation; empty for the first of the pictures
Bytes apngBytes(const RawPng& file, const std::vector<Bytes>& pictures,
                const std::vector<std::uint16_t>& delays_ms, const Bytes& defaultPicture = {});

/// Writes a file, and the folders above it.
void saveBytes(const std::filesystem::path& file, const Bytes& bytes);

}  // namespace poinsot
