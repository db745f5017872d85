// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "fuzz/input.h"
#include "image/png_file.h"

namespace {

using poinsot::fuzz::Bytes;

/// Reports whether a picture is large but within the limits. Such pictures are skipped, because they only cost
/// time for clearing memory.
bool isLarge(Bytes png) {
  constexpr std::size_t kWidthAt = 16, kHeightAt = 20, kEnd = 24;
  if (png.size() < kEnd) return false;
  const auto number = [&](std::size_t at) {
    return std::uint64_t{png[at]} << 24 | std::uint64_t{png[at + 1]} << 16 | std::uint64_t{png[at + 2]} << 8 |
           png[at + 3];
  };
  const std::uint64_t width = number(kWidthAt), height = number(kHeightAt), most = poinsot::image::kLargestPngSide;
  return width <= most && height <= most && width * height > (1 << 18);
}

std::uint32_t crc32(Bytes bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const std::uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~sum;
}

/// Returns the file with correct checksums in all chunks, as in a malicious file. Without this, the first checksum
/// would reject nearly all inputs.
std::vector<std::uint8_t> repaired(Bytes png) {
  std::vector<std::uint8_t> fixed(png.begin(), png.end());
  constexpr std::size_t kSignature = 8, kAround = 12;
  for (std::size_t at = kSignature; at + kAround <= fixed.size();) {
    const std::size_t length = std::size_t{fixed[at]} << 24 | std::size_t{fixed[at + 1]} << 16 |
                               std::size_t{fixed[at + 2]} << 8 | fixed[at + 3];
    if (length > fixed.size() - at - kAround) break;
    const std::uint32_t sum = crc32(Bytes(fixed).subspan(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      fixed[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += length + kAround;
  }
  return fixed;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto png = repaired({data, size});
  if (isLarge(png)) return -1;
  try {
    poinsot::image::decodePngAsStored(png, "picture");
  } catch (const poinsot::core::Error& error) {
    poinsot::fuzz::expectPrintable(error.what());
  }
  poinsot::image::textsOfWholePng(png);
  return 0;
}
