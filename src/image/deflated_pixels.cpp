// SPDX-License-Identifier: Apache-2.0
// The only file that includes ISA-L.
#include "image/deflated_pixels.h"

#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/expect.h"
#include "image/row_filter.h"

namespace poinsot::image {
namespace {

// Base-2 logarithm of the size of the compression window in bytes. A filtered row seldom repeats more than its
// last pixels. With a window of 8 bytes, files are a tenth smaller than with the usual 32 KiB, because distant
// matches save less than the code of their distance costs. Measured on eight pictures of 1920x1080, with filters,
// on one core of a virtual AMD EPYC: ISA-L 2.30 takes 3 to 7 ms and writes 122 to 421 kB. libdeflate 1.14 at level
// 4 without filters takes 17 to 21 ms; files are 8 % smaller on average.
constexpr std::uint16_t kWindowBits = 3;
constexpr std::uint32_t kTableBytes = ISAL_DEF_LVL1_DEFAULT;
// Number of bytes passed to ISA-L at once. ISA-L copies smaller inputs, which costs time. Much larger inputs no
// longer fit the CPU's caches.
constexpr std::size_t kBatchBytes = 1 << 16;
constexpr std::size_t kPieceBytes = 1 << 16;
// Number of bytes passed to ISA-L in the first call. With a longer first input, about one picture in thirty has
// different bytes from run to run, because of an error in ISA-L 2.30 to 2.32. Short inputs take another path,
// which is correct.
// The error: `.write_first_byte` of igzip_icf_body_h1_gr_bt.asm reads a register that still contains the address
// of the stream. It therefore hashes this address instead of the bytes that follow the third byte.
constexpr std::size_t kFirstBytes = 4;

class Deflater {
 public:
  Deflater() : tables_(kTableBytes) {
    isal_deflate_init(&stream_);
    stream_.level = 1;
    stream_.level_buf = tables_.data();
    stream_.level_buf_size = kTableBytes;
    stream_.gzip_flag = IGZIP_ZLIB;
    stream_.hist_bits = kWindowBits;
    batch_.reserve(2 * kBatchBytes);
  }

  void add(std::span<const std::uint8_t> bytes) {
    batch_.insert(batch_.end(), bytes.begin(), bytes.end());
    if (batch_.size() >= kBatchBytes) deflateBatch();
  }

  std::vector<std::uint8_t> finish() {
    last_ = true;
    deflateBatch();
    POINSOT_EXPECT(stream_.internal_state.state == ZSTATE_END);
    return std::move(out_);
  }

 private:
  void deflateBatch() {
    std::span<std::uint8_t> bytes = batch_;
    if (stream_.total_in == 0 && bytes.size() > kFirstBytes) {
      stream_.flush = SYNC_FLUSH;
      deflate(bytes.first(kFirstBytes));
      bytes = bytes.subspan(kFirstBytes);
    }
    stream_.flush = NO_FLUSH;
    stream_.end_of_stream = last_;
    deflate(bytes);
    batch_.clear();
  }

  void deflate(std::span<std::uint8_t> bytes) {
    stream_.next_in = bytes.data();
    stream_.avail_in = static_cast<std::uint32_t>(bytes.size());
    do {
      const std::size_t size = out_.size();
      out_.resize(size + kPieceBytes);
      stream_.next_out = out_.data() + size;
      stream_.avail_out = kPieceBytes;
      const int result = isal_deflate(&stream_);
      POINSOT_EXPECT(result == COMP_OK);  // an error could come only from the settings above
      out_.resize(out_.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

  std::vector<std::uint8_t> tables_, batch_, out_;
  isal_zstream stream_{};
  bool last_ = false;
};

void copyBigEndian(const std::uint8_t* samples, std::size_t count, std::uint8_t* to) {
  std::copy_n(samples, count, to);
}

void copyBigEndian(const std::uint16_t* samples, std::size_t count, std::uint8_t* to) {
  for (std::size_t i = 0; i < count; ++i, to += 2) {
    to[0] = static_cast<std::uint8_t>(samples[i] >> 8);
    to[1] = static_cast<std::uint8_t>(samples[i] & 0xFF);
  }
}

template <typename Sample>
std::vector<std::uint8_t> deflated(const BasicImage<Sample>& picture) {
  RowFilter filter(picture.rowBytes(), static_cast<std::size_t>(picture.channels) * sizeof(Sample));
  Deflater deflater;
  for (int y = 0; y < picture.size.height; ++y) {
    copyBigEndian(picture.at(0, y), picture.rowSamples(), filter.next());
    deflater.add(filter.filtered());
  }
  return deflater.finish();
}

}  // namespace

std::vector<std::uint8_t> deflatedPixels(const Image& picture) { return deflated(picture); }
std::vector<std::uint8_t> deflatedPixels(const DeepImage& picture) { return deflated(picture); }

}  // namespace poinsot::image
