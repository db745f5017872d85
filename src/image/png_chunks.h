// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace poinsot::image {

/// First eight bytes of every PNG file.
inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// Whether `bytes` begin with `text`.
bool startsWith(std::span<const std::uint8_t> bytes, std::string_view text);

/// One chunk of a PNG file. Its checksum is not examined.
struct PngChunk {
  std::string_view type;  ///< four letters
  std::span<const std::uint8_t> data;
};

/// Walks through the chunks of a PNG file in their order, without decoding anything.
class PngChunks {
 public:
  explicit PngChunks(std::span<const std::uint8_t> file);
  /// Returns the next chunk; nothing after IEND, at the end, in a file without signature and where a chunk is cut
  /// off.
  std::optional<PngChunk> next();
  /// Whether the walk stopped at a chunk that is longer than what is left of the file.
  bool isCutOff() const { return cutOff_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool cutOff_ = false;
};

}  // namespace poinsot::image
