// SPDX-License-Identifier: Apache-2.0
#include "output/animation_text.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::output {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};
// Header of an iTXt chunk: the keyword "Comment", no compression, no language, and no translated keyword.
constexpr std::string_view kPngTextHead{"Comment\0\0\0\0\0", 12};
constexpr std::uint8_t kTrailer = 0x3B, kExtension = 0x21, kImage = 0x2C, kComment = 0xFE;

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

/// Returns a GIF comment extension: blocks of up to 255 bytes, ended by an empty block.
Bytes gifComment(std::string_view text) {
  Bytes bytes{kExtension, kComment};
  for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(text.size(), 255))) {
    const std::string_view block = text.substr(0, 255);
    bytes.push_back(static_cast<std::uint8_t>(block.size()));
    append(bytes, block);
  }
  bytes.push_back(0);
  return bytes;
}

// The code below throws std::ios_base::failure if a file ends too early or has unexpected content.

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) {
    in_.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    std::error_code ignored;
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
    byte();  // seekg() alone may pass the end of the file
  }
  void expect(bool good) {
    if (!good) in_.setstate(std::ios::failbit);
  }

 private:
  std::ifstream in_;
};

// The texts are stored before the pictures. Older versions of this program stored them at the end of the file.
using Texts = std::vector<std::string>;

void readPng(Reader reader, Texts& texts) {
  reader.expect(reader.bytes(kPngSignature.size()) == kPngSignature);
  for (;;) {
    const std::uint32_t size = reader.bigEndian();
    const std::string type = reader.bytes(4);
    if (type == "IEND" || (type == "IDAT" && !texts.empty())) return;
    if (type == "iTXt" && size >= kPngTextHead.size() && size < 100'000) {
      const std::string data = reader.bytes(size);
      if (data.starts_with(kPngTextHead)) texts.push_back(data.substr(kPngTextHead.size()));
      reader.skip(4);
    } else {
      reader.skip(std::int64_t{size} + 4);
    }
  }
}

std::string gifBlocks(Reader& reader) {
  std::string data;
  while (const std::uint8_t size = reader.byte()) data += reader.bytes(size);
  return data;
}

std::int64_t gifColors_bytes(std::uint8_t flags) {
  return (flags & 0x80) != 0 ? std::int64_t{6} << (flags & 7) : 0;
}

void skipGifColors(Reader& reader, std::uint8_t flags) {
  if (const std::int64_t bytes = gifColors_bytes(flags); bytes > 0) reader.skip(bytes);
}

void readGif(Reader reader, Texts& texts) {
  reader.expect(reader.bytes(6) == "GIF89a");
  const std::string screen = reader.bytes(7);
  skipGifColors(reader, static_cast<std::uint8_t>(screen[4]));
  for (int kind = reader.byte(); kind != kTrailer; kind = reader.byte()) {
    reader.expect(kind == kExtension || kind == kImage);
    if (kind == kImage) {
      if (!texts.empty()) return;
      const std::string place = reader.bytes(9);
      skipGifColors(reader, static_cast<std::uint8_t>(place[8]));
      reader.skip(1);  // LZW's minimum code size
      gifBlocks(reader);
    } else {
      const bool comment = reader.byte() == kComment;
      const std::string data = gifBlocks(reader);
      if (comment) texts.push_back(data);
    }
  }
}

std::int64_t placeOfTexts(FileFormat format, const std::string& head) {
  constexpr std::int64_t kPngHeader_bytes = 8 + 25, kGifScreen_bytes = 13;
  constexpr std::size_t kGifFlags = 10;
  if (format == FileFormat::kApng) return kPngHeader_bytes;
  return kGifScreen_bytes + gifColors_bytes(static_cast<std::uint8_t>(head.at(kGifFlags)));
}

}  // namespace

bool isAnimation(FileFormat format) { return format == FileFormat::kGif || format == FileFormat::kApng; }

std::string animationText(FileFormat format, const std::string& text) {
  const Bytes bytes =
      format == FileFormat::kApng ? pngChunk("iTXt", std::string(kPngTextHead) + text) : gifComment(text);
  return {bytes.begin(), bytes.end()};
}

void insertTexts(core::AtomicFile& film, FileFormat format, const std::vector<std::string>& texts) {
  constexpr std::size_t kHead = 64, kBlock = 1 << 20;
  std::string inserted;
  for (const std::string& text : texts) inserted += animationText(format, text);
  const auto size = static_cast<std::int64_t>(inserted.size());
  const std::int64_t place = placeOfTexts(format, film.readAt(0, kHead));
  // Moves the last block first, because old and new positions overlap in the same file.
  for (std::int64_t end = film.size(); end > place;) {
    const std::int64_t begin = std::max<std::int64_t>(place, end - static_cast<std::int64_t>(kBlock));
    film.writeAt(begin + size, film.readAt(begin, static_cast<std::size_t>(end - begin)));
    end = begin;
  }
  film.writeAt(place, inserted);
}

std::vector<std::string> animationTexts(const std::filesystem::path& file) {
  Texts texts;
  try {
    filmContainer(file) == FilmContainer::kApng ? readPng(Reader(file), texts) : readGif(Reader(file), texts);
  } catch (const std::ios_base::failure&) {
    if (texts.empty()) throw core::ioError(core::printable(file.native()) + ": cannot be read as a film");
  }
  return texts;
}

}  // namespace poinsot::output
