// SPDX-License-Identifier: Apache-2.0
#include "image/png_chunks.h"

#include <cstring>

namespace poinsot::image {
namespace {

std::uint32_t bigEndian32(std::span<const std::uint8_t> b) {
  return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
}

}  // namespace

bool startsWith(std::span<const std::uint8_t> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

PngChunks::PngChunks(std::span<const std::uint8_t> file) {
  if (startsWith(file, kPngSignature)) rest_ = file.subspan(kPngSignature.size());
}

std::optional<PngChunk> PngChunks::next() {
  // Number of bytes before a chunk's data (length and type), and before and after it together (also the checksum).
  constexpr std::size_t kHead = 8, kAround = 12;
  if (rest_.empty() || cutOff_) return std::nullopt;
  if (rest_.size() < kAround || bigEndian32(rest_) > rest_.size() - kAround) {
    cutOff_ = true;
    return std::nullopt;
  }
  const std::size_t length = bigEndian32(rest_);
  const PngChunk chunk{{reinterpret_cast<const char*>(rest_.data()) + 4, 4}, rest_.subspan(kHead, length)};
  rest_ = chunk.type == "IEND" ? std::span<const std::uint8_t>() : rest_.subspan(kAround + length);
  return chunk;
}

}  // namespace poinsot::image
