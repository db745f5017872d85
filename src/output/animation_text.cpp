// SPDX-License-Identifier: Apache-2.0
#include "output/animation_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "output/ffmpeg_container.h"

namespace poinsot::output {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
// Keyword, then: not compressed, no language, no translated keyword.
constexpr std::string_view kPngTextHead{"Comment\0\0\0\0\0", 12};
constexpr int kTrailer = 0x3B, kExtension = 0x21, kImage = 0x2C, kComment = 0xFE;

/// The mark in the first line, the comment in the second, then the others.
std::string joined(const std::vector<FilmText>& texts) {
  std::string comment, others;
  for (const FilmText& text : texts) (text.key == "comment" ? comment : others) += text.value + "\n";
  return ownMark() + "\n" + comment + others;
}

void append(Bytes& bytes, std::string_view text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

void appendBigEndian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

Bytes pngChunk(std::string_view type, std::string_view data) {
  Bytes bytes;
  appendBigEndian(bytes, static_cast<std::uint32_t>(data.size()));
  append(bytes, type);
  append(bytes, data);
  const std::uint32_t crc =
      ffmpeg().av_crc(ffmpeg().av_crc_get_table(AV_CRC_32_IEEE_LE), ~0u, bytes.data() + 4, bytes.size() - 4);
  appendBigEndian(bytes, ~crc);
  return bytes;
}

AnimationEnd pngEnd(const std::string& text) {
  Bytes bytes = pngChunk("iTXt", std::string(kPngTextHead) + text);
  const Bytes end = pngChunk("IEND", "");
  bytes.insert(bytes.end(), end.begin(), end.end());
  return {end.size(), std::move(bytes)};
}

AnimationEnd gifEnd(std::string_view text) {
  Bytes bytes{kExtension, kComment};
  for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(text.size(), 255))) {
    const std::string_view block = text.substr(0, 255);
    bytes.push_back(static_cast<std::uint8_t>(block.size()));
    append(bytes, block);
  }
  bytes.insert(bytes.end(), {0, kTrailer});
  return {1, std::move(bytes)};
}

// ---- reading: whatever ends too early, or is not what it should be, throws std::ios_base::failure

struct Found {
  std::int64_t frames = 0;
  std::string text;
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) {
    in_.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    std::error_code ignored;  // what cannot be asked is not opened either
    expect(std::filesystem::is_regular_file(file, ignored));
    in_.open(file, std::ios::binary);
  }
  std::string bytes(std::size_t count) {
    std::string bytes(count, '\0');
    in_.read(bytes.data(), static_cast<std::streamsize>(count));
    return bytes;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(bytes(1)[0]); }
  std::uint32_t bigEndian() {
    std::uint32_t value = 0;
    for (const char c : bytes(4)) value = value << 8 | static_cast<std::uint8_t>(c);
    return value;
  }
  void skip(std::int64_t count) {
    in_.seekg(count - 1, std::ios::cur);
    byte();  // seeking alone goes beyond the end
  }
  void expect(bool good) {
    if (!good) in_.setstate(std::ios::failbit);
  }

 private:
  std::ifstream in_;
};

Found readPng(Reader reader) {
  Found found;
  reader.expect(reader.bytes(kPngSignature.size()) == kPngSignature);
  for (;;) {
    const std::uint32_t size = reader.bigEndian();
    const std::string type = reader.bytes(4);
    if (type == "IEND") break;
    if (type == "fcTL") ++found.frames;
    if (type == "iTXt" && size >= kPngTextHead.size() && size < 100'000) {
      const std::string data = reader.bytes(size);
      if (data.starts_with(kPngTextHead)) found.text = data.substr(kPngTextHead.size());
      reader.skip(4);
    } else {
      reader.skip(std::int64_t{size} + 4);
    }
  }
  reader.skip(4);
  return found;
}

/// Blocks of up to 255 bytes, up to an empty one.
std::string gifBlocks(Reader& reader) {
  std::string data;
  while (const std::uint8_t size = reader.byte()) data += reader.bytes(size);
  return data;
}

void skipGifColors(Reader& reader, std::uint8_t flags) {
  if ((flags & 0x80) != 0) reader.skip(std::int64_t{6} << (flags & 7));
}

Found readGif(Reader reader) {
  Found found;
  reader.expect(reader.bytes(6) == "GIF89a");
  const std::string screen = reader.bytes(7);
  skipGifColors(reader, static_cast<std::uint8_t>(screen[4]));
  for (int kind = reader.byte(); kind != kTrailer; kind = reader.byte()) {
    reader.expect(kind == kExtension || kind == kImage);
    if (kind == kImage) {
      ++found.frames;
      const std::string place = reader.bytes(9);
      skipGifColors(reader, static_cast<std::uint8_t>(place[8]));
      reader.skip(1);  // least size of a code
      gifBlocks(reader);
    } else {
      const bool comment = reader.byte() == kComment;
      const std::string data = gifBlocks(reader);
      if (comment) found.text = data;
    }
  }
  return found;
}

std::optional<Found> find(const std::filesystem::path& file) try {
  const bool png = filmContainer(file) == FilmContainer::kApng;
  return png ? readPng(Reader(file)) : readGif(Reader(file));
} catch (const std::ios_base::failure&) {
  return std::nullopt;
}

}  // namespace

AnimationEnd animationEnd(FilmContainer container, const std::vector<FilmText>& texts) {
  return container == FilmContainer::kApng ? pngEnd(joined(texts)) : gifEnd(joined(texts));
}

std::optional<FilmFacts> readAnimationFacts(const std::filesystem::path& file) {
  const auto found = find(file);
  const std::string mark = ownMark() + "\n";
  if (!found || !found->text.starts_with(mark)) return std::nullopt;
  const std::string rest = found->text.substr(mark.size());
  return FilmFacts{found->frames, rest.substr(0, rest.find('\n'))};
}

bool isOwnAnimation(const std::filesystem::path& file) {
  const auto found = find(file);
  return found && found->text.starts_with("poinsot ");
}

}  // namespace poinsot::output
