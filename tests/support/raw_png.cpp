// SPDX-License-Identifier: Apache-2.0
#include "support/raw_png.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace poinsot {
namespace {

constexpr int kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type

Bytes bigEndian(std::uint32_t v, int bytes = 4) {
  Bytes out;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(v >> shift));
  return out;
}

void append(Bytes& to, const Bytes& more) { std::ranges::copy(more, std::back_inserter(to)); }

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes out;
  for (const Bytes& part : parts) append(out, part);
  return out;
}

Bytes header(const RawPng& file) {
  return pngChunk("IHDR",
                  joined({bigEndian(file.width), bigEndian(file.height), {file.depth, file.colorType, 0, 0, 0}}));
}

/// Returns the rows as a zlib stream, each row after filter type 0.
Bytes packed(const RawPng& file, const Bytes& samples) {
  const std::size_t row = (std::size_t{file.width} * file.depth * kChannels[file.colorType] + 7) / 8;
  Bytes rows;
  for (std::size_t y = 0; y < file.height; ++y) {
    rows.push_back(0);
    std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(y * row), row, std::back_inserter(rows));
  }
  Bytes out(compressBound(rows.size()));
  uLongf size = out.size();
  compress(out.data(), &size, rows.data(), rows.size());
  out.resize(size);
  return out;
}

const Bytes kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

}  // namespace

Bytes pngChunk(const std::string& type, const Bytes& data) {
  Bytes out = bigEndian(static_cast<std::uint32_t>(data.size()));
  std::ranges::copy(type, std::back_inserter(out));
  append(out, data);
  append(out, bigEndian(static_cast<std::uint32_t>(crc32(0, out.data() + 4, static_cast<uInt>(out.size() - 4)))));
  return out;
}

Bytes pngBytes(const RawPng& file, const Bytes& samples) {
  return joined({kSignature, header(file), joined(file.chunks), pngChunk("IDAT", packed(file, samples)),
                 pngChunk("IEND", {})});
}

Bytes apngBytes(const RawPng& file, const std::vector<Bytes>& pictures,
                const std::vector<std::uint16_t>& delays_ms, const Bytes& defaultPicture) {
  const auto frames = static_cast<std::uint32_t>(pictures.size());
  Bytes out = joined({kSignature, header(file), joined(file.chunks),
                      pngChunk("acTL", joined({bigEndian(frames), bigEndian(0)}))});
  const bool hidden = !defaultPicture.empty();
  if (hidden) append(out, pngChunk("IDAT", packed(file, defaultPicture)));
  std::uint32_t sequence = 0;
  for (std::uint32_t i = 0; i < frames; ++i) {
    append(out, pngChunk("fcTL", joined({bigEndian(sequence++),
                                         bigEndian(file.width),
                                         bigEndian(file.height),
                                         bigEndian(0),
                                         bigEndian(0),
                                         bigEndian(delays_ms[i], 2),
                                         bigEndian(1000, 2),
                                         {0, 0}})));
    const Bytes data = packed(file, pictures[i]);
    const bool inIdat = i == 0 && !hidden;
    append(out, inIdat ? pngChunk("IDAT", data) : pngChunk("fdAT", joined({bigEndian(sequence++), data})));
  }
  append(out, pngChunk("IEND", {}));
  return out;
}

void saveBytes(const std::filesystem::path& file, const Bytes& bytes) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace poinsot
