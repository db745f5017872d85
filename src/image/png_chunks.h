// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace poinsot::image {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

bool startsWith(std::span<const std::uint8_t> bytes, std::string_view text);

/// Chunk of a PNG file. Its checksum is not verified.
struct PngChunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
};

/// Reads the chunks of a PNG file in order, without decoding them.
class PngChunks {
 public:
  explicit PngChunks(std::span<const std::uint8_t> file);
  /// Returns the next chunk, or nullopt after IEND, at the end, at a truncated chunk or without a PNG signature.
  std::optional<PngChunk> next();
  /// Reports whether next() stopped at a chunk that is longer than the rest of the file.
  bool isCutOff() const { return cutOff_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool cutOff_ = false;
};

}  // namespace poinsot::image
