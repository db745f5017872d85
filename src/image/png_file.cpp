// SPDX-License-Identifier: Apache-2.0
// The only file that includes png.h.
//
// libpng reports errors by longjmp, which runs no destructors; skipping the destructor of a C++ object is
// undefined behaviour. Functions that call setjmp, such as writeFile(), and callbacks therefore have only local
// variables that need no destructor. Their callers own all memory and get a bool as result.
#include "image/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <new>

#include "core/expect.h"
#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "core/version.h"
#include "image/deflated_pixels.h"
#include "image/png_chunks.h"

namespace poinsot::image {
namespace {

using core::Error;
using core::ErrorKind;

/// Last error message of libpng, set by onError(). The text is a plain array, because onError() ends in a longjmp,
/// which runs no destructors.
struct Complaint {
  std::array<char, 160> text{};
};

void onError(png_structp png, png_const_charp message) {
  auto* complaint = static_cast<Complaint*>(png_get_error_ptr(png));
  std::strncpy(complaint->text.data(), message, complaint->text.size() - 1);
  png_longjmp(png, 1);
}

// Warnings are ignored; readHeader() turns wrong checksums into errors
void onWarning(png_structp, png_const_charp) {}

class Writer {
 public:
  Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint_, onError, onWarning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &bytes_, append, nullptr);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }
  std::vector<std::uint8_t>& bytes() { return bytes_; }
  const char* complaint() const { return complaint_.text.data(); }

 private:
  static bool grow(std::vector<std::uint8_t>& out, const std::uint8_t* data, std::size_t size) noexcept try {
    out.insert(out.end(), data, data + size);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
  static void append(png_structp png, png_bytep data, std::size_t size) {
    auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    if (!grow(*out, data, size)) png_error(png, "out of memory");
  }

  Complaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<std::uint8_t> bytes_;
};

struct Header {
  png_uint_32 width, height;
  int bits, type;
  png_uint_32 pixelsPerMetre;
};

/// Writes a complete PNG file with the compressed pixels `data`. libpng could compress the pixels itself, but its
/// zlib takes several times as long.
bool writeFile(png_structp png, png_infop info, const Header& header, png_textp texts, int textCount,
               std::span<const std::uint8_t> data) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, header.width, header.height, header.bits, header.type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (header.pixelsPerMetre > 0)
    png_set_pHYs(png, info, header.pixelsPerMetre, header.pixelsPerMetre, PNG_RESOLUTION_METER);
  png_set_text(png, info, texts, textCount);
  png_write_info(png, info);
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), data.data(), data.size());
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  return true;
}

bool printableAscii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

png_text textChunk(PngText& text) {
  POINSOT_EXPECT(!text.key.empty() && text.key.size() <= 79 && printableAscii(text.key));
  png_text chunk{};
  // A tEXt chunk is encoded in Latin-1, an iTXt chunk in UTF-8. Text beyond ASCII is written as iTXt.
  chunk.compression = printableAscii(text.value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  chunk.key = text.key.data();
  chunk.text = text.value.data();
  return chunk;
}

using Remaining = std::span<const std::uint8_t>;

void consume(png_structp png, png_bytep to, std::size_t size) {
  auto* remaining = static_cast<Remaining*>(png_get_io_ptr(png));
  if (remaining->size() < size) png_error(png, "the file ends too early");
  std::memcpy(to, remaining->data(), size);
  *remaining = remaining->subspan(size);
}

class Reader {
 public:
  explicit Reader(Remaining bytes)
      : remaining_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, onError, onWarning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &remaining_, consume);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }
  const char* complaint() const { return complaint_.text.data(); }
  Remaining remaining() const { return remaining_; }

 private:
  Complaint complaint_;
  Remaining remaining_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

bool readHeader(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  // libpng keeps decompressed texts in memory. The product of these two limits is the most memory that a small
  // file can use in addition to its pixels.
  constexpr png_alloc_size_t kLargestChunk = 1 << 20;
  constexpr png_uint_32 kMostChunks = 64;
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkSize() applies our own limits
  png_set_chunk_malloc_max(png, kLargestChunk);
  png_set_chunk_cache_max(png, kMostChunks);
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_read_info(png, info);
  return true;
}

bool prepareRows(png_structp png, png_infop info, bool keep16) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_expand(png);  // converts palettes, grey of 1 to 4 bits and tRNS chunks to 8-bit samples and alpha
  if (!keep16)
    png_set_scale_16(png);
  else if (std::endian::native == std::endian::little)
    png_set_swap(png);
  png_set_gray_to_rgb(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool readPixels(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

void checkSize(png_structp png, png_infop info, std::string_view name) {
  const std::uint64_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  const std::uint64_t pixelBytes = png_get_bit_depth(png, info) == 16 ? 8 : 4;
  if (width <= kLargestPngSide && height <= kLargestPngSide && width * height * pixelBytes <= kLargestPngBytes)
    return;
  throw core::limitError(
      fmt::format("{}: the picture is {}x{} pixels; at most {} per side and {} MiB decoded are read",
                  core::printable(name), width, height, kLargestPngSide, kLargestPngBytes >> 20));
}

template <typename Sample>
std::vector<png_bytep> rowsOf(BasicImage<Sample>& picture) {
  std::vector<png_bytep> rows;
  for (int y = 0; y < picture.size.height; ++y) rows.push_back(reinterpret_cast<png_bytep>(picture.at(0, y)));
  return rows;
}

std::string fileBytes(const std::filesystem::path& path) {
  try {
    // PNG files within the limits of decodePng() are never longer. A longer file is cut here and rejected later.
    return core::bytesOf(core::openForReading(path), kLargestPngBytes * 2, ErrorKind::kIo);
  } catch (const Error& error) {
    throw core::FileError(ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()), error.message()),
                          path, core::codeOf(error));
  }
}

std::span<const std::uint8_t> asBytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

template <typename Sample>
std::vector<std::uint8_t> encoded(const BasicImage<Sample>& picture, const std::vector<PngText>& texts,
                                  double dpi) {
  POINSOT_EXPECT(picture.pixels.size() == picture.rowSamples() * static_cast<std::size_t>(picture.size.height));
  std::vector<PngText> all = {{"Software", fmt::format("poinsot {}", core::version())}};
  all.insert(all.end(), texts.begin(), texts.end());
  std::vector<png_text> chunks;
  for (PngText& text : all) chunks.push_back(textChunk(text));

  constexpr double kInch_m = 0.0254;
  const auto pixelsPerMetre = static_cast<png_uint_32>(std::lround(dpi / kInch_m));
  const Header header{static_cast<png_uint_32>(picture.size.width), static_cast<png_uint_32>(picture.size.height),
                      8 * sizeof(Sample), picture.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                      pixelsPerMetre};
  const auto data = deflatedPixels(picture);
  Writer writer;
  if (!writeFile(writer.png(), writer.info(), header, chunks.data(), static_cast<int>(chunks.size()), data))
    throw core::encodeError(fmt::format("writing a PNG: {}", writer.complaint()));
  return std::move(writer.bytes());
}

void check(bool done, const Reader& reader, std::string_view name) {
  if (done) return;
  throw core::ioError(
      fmt::format("{}: not a readable PNG: {}", core::printable(name), core::printable(reader.complaint())));
}

PngStorage storageOf(png_structp png, png_infop info) {
  const int type = png_get_color_type(png, info);
  const bool alpha = (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  return {((type & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1) + (alpha ? 1 : 0), (type & PNG_COLOR_MASK_PALETTE) != 0,
          png_get_bit_depth(png, info) == 16};
}

/// Returns the codes in the cICP chunk of a file. libpng 1.6.39 (Debian 12) does not support this chunk.
std::optional<std::array<std::uint8_t, 4>> cicpOf(Remaining file) {
  PngChunks chunks(file);
  for (auto chunk = chunks.next(); chunk && chunk->type != "IDAT"; chunk = chunks.next()) {
    std::array<std::uint8_t, 4> codes{};
    if (chunk->type != "cICP" || chunk->data.size() != codes.size()) continue;
    std::ranges::copy(chunk->data, codes.begin());
    return codes;
  }
  return std::nullopt;
}

/// Returns the colour chunks of a file except cICP. The header must have been read. The reader owns the profile.
PngColorChunks colorChunksOf(png_structp png, png_infop info) {
  PngColorChunks chunks;
  chunks.isSrgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
  png_charp name = nullptr;
  int compression = 0;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  if (png_get_iCCP(png, info, &name, &compression, &profile, &size) != 0) {
    chunks.profileName = name;
    chunks.profile = {profile, size};
  }
  if (double gamma = 0; png_get_gAMA(png, info, &gamma) != 0) chunks.gamma = gamma;
  std::array<png_fixed_point, 8> xy{};
  if (png_get_cHRM_fixed(png, info, &xy[0], &xy[1], &xy[2], &xy[3], &xy[4], &xy[5], &xy[6], &xy[7]) != 0)
    std::ranges::copy(xy, chunks.primaries.emplace().begin());
  return chunks;
}

template <typename Sample>
BasicImage<Sample> decodedPixels(Reader& reader, std::string_view name) {
  check(prepareRows(reader.png(), reader.info(), sizeof(Sample) == 2), reader, name);
  const PixelSize size = {static_cast<int>(png_get_image_width(reader.png(), reader.info())),
                          static_cast<int>(png_get_image_height(reader.png(), reader.info()))};
  BasicImage<Sample> picture(size, png_get_channels(reader.png(), reader.info()));
  check(readPixels(reader.png(), rowsOf(picture).data()), reader, name);
  return picture;
}

std::string firstOfTypes(Remaining file, std::initializer_list<std::string_view> types) {
  PngChunks chunks(file);
  for (auto chunk = chunks.next(); chunk; chunk = chunks.next())
    if (std::ranges::find(types, chunk->type) != types.end()) return std::string(chunk->type);
  return "";
}

/// Reports whether the file ends within a chunk. Without this check, libpng would allocate memory for the complete
/// chunk, up to 2 GiB, before it notices that bytes are missing.
bool endsWithinAChunk(Remaining bytes) {
  PngChunks chunks(bytes);
  while (chunks.next()) continue;
  return chunks.isCutOff();  // libpng reports a missing chunk, so only a truncated one is reported here
}

/// Returns the reason if the bytes are certainly not a complete PNG file; empty if libpng may read them.
std::string_view faultOf(Remaining bytes) {
  if (bytes.empty()) return "the file is empty";
  if (startsWith(bytes, "version https://git-lfs.github.com/spec/"))
    return "the file is a Git LFS pointer; get the picture with `git lfs pull`";
  if (!startsWith(bytes, kPngSignature.substr(0, std::min(bytes.size(), kPngSignature.size()))))
    return "Not a PNG file";
  return bytes.size() < kPngSignature.size() || endsWithinAChunk(bytes) ? "the file ends too early" : "";
}

void readHeader(Reader& reader, std::string_view name) {
  if (const auto fault = faultOf(reader.remaining()); !fault.empty())
    throw core::ioError(fmt::format("{}: not a readable PNG: {}", core::printable(name), fault));
  check(readHeader(reader.png(), reader.info()), reader, name);
  checkSize(reader.png(), reader.info(), name);
}

Image decoded(Reader& reader, std::string_view name) {
  readHeader(reader, name);
  return decodedPixels<std::uint8_t>(reader, name);
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image& picture, const std::vector<PngText>& texts, double dpi) {
  return encoded(picture, texts, dpi);
}

std::vector<std::uint8_t> encodePng(const DeepImage& picture, const std::vector<PngText>& texts, double dpi) {
  return encoded(picture, texts, dpi);
}

Image decodePng(std::span<const std::uint8_t> bytes, std::string_view name) {
  Reader reader(bytes);
  return decoded(reader, name);
}

PngPicture decodePngAsStored(std::span<const std::uint8_t> bytes, std::string_view name) {
  Reader reader(bytes);
  readHeader(reader, name);
  PngColorChunks chunks = colorChunksOf(reader.png(), reader.info());
  chunks.cicp = cicpOf(bytes);
  const PngStorage stored = storageOf(reader.png(), reader.info());
  const ColorTag color = colorTagOf(chunks);
  if (stored.deep) return {decodedPixels<std::uint16_t>(reader, name), stored, color};
  return {decodedPixels<std::uint8_t>(reader, name), stored, color};
}

bool isAnimatedPng(const std::filesystem::path& path) try {
  // Number of bytes read first; nearly always enough to reach the pixels
  constexpr std::uint64_t kHead = 64 << 10;
  const std::string head = core::bytesOf(core::openForReading(path), kHead, ErrorKind::kIo);
  const auto type = firstOfTypes(asBytes(head), {"acTL", "IDAT"});
  if (!type.empty() || head.size() < kHead) return type == "acTL";
  return firstOfTypes(asBytes(fileBytes(path)), {"acTL", "IDAT"}) == "acTL";
} catch (const Error&) {
  return false;
}

PngPicture readPngAsStored(const std::filesystem::path& path) {
  return decodePngAsStored(asBytes(fileBytes(path)), path.native());
}

Image readPng(const std::filesystem::path& path) { return decodePng(asBytes(fileBytes(path)), path.native()); }

std::optional<std::vector<PngText>> textsOfWholePng(const std::filesystem::path& path) try {
  return textsOfWholePng(asBytes(fileBytes(path)));
} catch (const Error&) {
  return std::nullopt;
}

std::optional<std::vector<PngText>> textsOfWholePng(std::span<const std::uint8_t> bytes) try {
  Reader reader(bytes);
  decoded(reader, "");
  png_textp chunks = nullptr;
  const png_uint_32 count = png_get_text(reader.png(), reader.info(), &chunks, nullptr);
  std::vector<PngText> texts;
  for (png_uint_32 i = 0; i < count; ++i) texts.push_back({chunks[i].key, chunks[i].text});
  return texts;
} catch (const Error&) {
  return std::nullopt;
}

bool isPngName(const std::filesystem::path& file) {
  const std::string extension = file.extension();
  return std::ranges::equal(extension, std::string_view(".png"),
                            [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool isOwnPng(const std::filesystem::path& path, std::string_view key) try {
  constexpr std::uint64_t kHead = 64 << 10;  // number of bytes read; the Software text is within the first 200
  const std::string head = core::bytesOf(core::openForReading(path), kHead, ErrorKind::kIo);
  PngChunks chunks(asBytes(head));
  const std::string keyed = std::string(key) + '\0';
  bool isOwn = false, hasKey = key.empty();
  for (auto chunk = chunks.next(); chunk && chunk->type != "IDAT"; chunk = chunks.next()) {
    if (chunk->type != "tEXt") continue;
    isOwn = isOwn || startsWith(chunk->data, std::string_view("Software\0poinsot ", 17));
    hasKey = hasKey || startsWith(chunk->data, keyed);
  }
  return isOwn && hasKey;
} catch (const Error&) {
  return false;
}

std::string libpngVersion() { return png_get_libpng_ver(nullptr); }

}  // namespace poinsot::image
