// SPDX-License-Identifier: Apache-2.0
#include "output/yuv.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/expect.h"
#include "output/yuv_weights.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace poinsot::output {
namespace {

// Scale of the integer weights. Luma is scaled by 2^22; its largest sum, 235 · 2^22, fits 31 bits. Chroma is
// scaled by 2^19, because it adds 8 samples (with weights 1 2 1 on two rows), and 8 · 2^19 is 2^22.
constexpr int kShift = 22;
constexpr double kLumaScale = 4194304;
constexpr double kChromaScale = 524288;

constexpr Weights kLuma = lumaWeights(kLumaScale);
constexpr Weights kCb = cbWeights(kChromaScale);
constexpr Weights kCr = crWeights(kChromaScale);

constexpr std::int32_t kHalf = 1 << (kShift - 1);
constexpr std::int32_t kLumaOffset = (16 << kShift) + kHalf;
constexpr std::int32_t kChromaOffset = (128 << kShift) + kHalf;

std::uint8_t weighed(const Weights& w, std::int32_t r, std::int32_t g, std::int32_t b, std::int32_t offset) {
  return static_cast<std::uint8_t>((w.r * r + w.g * g + w.b * b + offset) >> kShift);
}

constexpr std::ptrdiff_t pixelAt(int x, int channels) { return std::ptrdiff_t{x} * channels; }

void lumaRow(const std::uint8_t* rgb, int channels, int from, int to, std::uint8_t* y) {
  rgb += pixelAt(from, channels);
  for (int x = from; x < to; ++x, rgb += channels) y[x] = weighed(kLuma, rgb[0], rgb[1], rgb[2], kLumaOffset);
}

void chromaRow(const std::uint8_t* upper, const std::uint8_t* lower, int channels, int from, int to,
               std::uint8_t* cb, std::uint8_t* cr) {
  for (int x = from; x < to; ++x) {
    const int here = 2 * x * channels, left = x > 0 ? here - channels : here, right = here + channels;
    std::array<std::int32_t, 3> sum{};
    for (int c = 0; c < 3; ++c)
      sum[static_cast<std::size_t>(c)] = upper[left + c] + lower[left + c] +
                                         2 * (upper[here + c] + lower[here + c]) + upper[right + c] +
                                         lower[right + c];
    cb[x] = weighed(kCb, sum[0], sum[1], sum[2], kChromaOffset);
    cr[x] = weighed(kCr, sum[0], sum[1], sum[2], kChromaOffset);
  }
}

#if defined(__SSE2__)
// Registers contain pixels as R G B X in 16-bit lanes. X is an arbitrary value and has weight 0.

/// Weights of up to 22 bits, split into 256 · high + low, because pmaddwd multiplies 16-bit numbers. Both products
/// are exact.
struct SplitWeights {
  __m128i high;
  __m128i low;
};

SplitWeights split(const Weights& w) {
  const auto lanes = [](std::int32_t r, std::int32_t g, std::int32_t b) {
    return _mm_setr_epi16(static_cast<short>(r), static_cast<short>(g), static_cast<short>(b), 0,
                          static_cast<short>(r), static_cast<short>(g), static_cast<short>(b), 0);
  };
  return {lanes(w.r >> 8, w.g >> 8, w.b >> 8), lanes(w.r & 255, w.g & 255, w.b & 255)};
}

/// Returns (r·R + g·G + b·B + offset) >> kShift for the four pixels in two registers, as four 32-bit results.
__m128i weighed(const SplitWeights& w, __m128i pixels01, __m128i pixels23, __m128i offset) {
  const auto partial = [&](__m128i weights) {
    const __m128 a = _mm_castsi128_ps(_mm_madd_epi16(pixels01, weights));  // lanes: rg0 b0 rg1 b1
    const __m128 b = _mm_castsi128_ps(_mm_madd_epi16(pixels23, weights));
    return _mm_add_epi32(_mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0))),
                         _mm_castps_si128(_mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1))));
  };
  const __m128i sum = _mm_add_epi32(_mm_slli_epi32(partial(w.high), 8), partial(w.low));
  return _mm_srai_epi32(_mm_add_epi32(sum, offset), kShift);
}

/// Returns four pixels as R G B X bytes. Reads 16 bytes.
template <int kChannels>
__m128i fourPixels(const std::uint8_t* from) {
  const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  if constexpr (kChannels == 4) return bytes;
  const __m128i first = _mm_unpacklo_epi32(bytes, _mm_srli_si128(bytes, 3));
  const __m128i second = _mm_unpacklo_epi32(_mm_srli_si128(bytes, 6), _mm_srli_si128(bytes, 9));
  return _mm_unpacklo_epi64(first, second);
}

__m128i lowHalf(__m128i bytes) { return _mm_unpacklo_epi8(bytes, _mm_setzero_si128()); }
__m128i highHalf(__m128i bytes) { return _mm_unpackhi_epi8(bytes, _mm_setzero_si128()); }

void store4(std::uint8_t* to, __m128i values) {
  const __m128i words = _mm_packs_epi32(values, values);
  const int bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
  __builtin_memcpy(to, &bytes, 4);
}

/// Range of columns in a row. It begins at a multiple of eight, and ends at one or at the end of the row.
struct Columns {
  int from, to;
  int width;
};

/// Returns the column at which the scalar code takes over. A load of four RGB pixels reads 4 bytes beyond them, so
/// the last pixels of a row need scalar code.
template <int kChannels>
int vectorEnd(const Columns& columns, int step) {
  const int usable = std::min(columns.to, kChannels == 4 ? columns.width : columns.width - 2);
  return std::max(columns.from, usable / step * step);
}

template <int kChannels>
void fastLumaRow(const std::uint8_t* rgb, const Columns& columns, std::uint8_t* y) {
  const SplitWeights luma = split(kLuma);
  const __m128i offset = _mm_set1_epi32(kLumaOffset);
  const int end = vectorEnd<kChannels>(columns, 4);
  for (int x = columns.from; x < end; x += 4) {
    const __m128i p = fourPixels<kChannels>(rgb + pixelAt(x, kChannels));
    store4(y + x, weighed(luma, lowHalf(p), highHalf(p), offset));
  }
  lumaRow(rgb, kChannels, end, columns.to, y);
}

/// Sums of two rows for eight pixels, two pixels in each register.
struct RowSums {
  __m128i p01, p23, p45, p67;
};

template <int kChannels>
RowSums rowSums(const std::uint8_t* upper, const std::uint8_t* lower) {
  const __m128i a = fourPixels<kChannels>(upper), b = fourPixels<kChannels>(lower);
  constexpr std::ptrdiff_t kNext = pixelAt(4, kChannels);
  const __m128i c = fourPixels<kChannels>(upper + kNext), d = fourPixels<kChannels>(lower + kNext);
  return {_mm_add_epi16(lowHalf(a), lowHalf(b)), _mm_add_epi16(highHalf(a), highHalf(b)),
          _mm_add_epi16(lowHalf(c), lowHalf(d)), _mm_add_epi16(highHalf(c), highHalf(d))};
}

/// Returns the sum of one pixel over two rows, in both halves of the register.
__m128i pixelSum(const std::uint8_t* upper, const std::uint8_t* lower) {
  const auto sum = [&](int c) { return static_cast<short>(upper[c] + lower[c]); };
  return _mm_setr_epi16(sum(0), sum(1), sum(2), 0, sum(0), sum(1), sum(2), 0);
}

/// Returns the sums with weights 1 2 1: left + 2 here + right in the low half, from [.. left] and [here right].
__m128i weighed121(__m128i left, __m128i hereRight) {
  const __m128i outer = _mm_unpackhi_epi64(_mm_add_epi16(left, hereRight), hereRight);
  return _mm_add_epi16(outer, _mm_slli_epi16(hereRight, 1));
}

template <int kChannels>
void fastChromaRow(const std::uint8_t* upper, const std::uint8_t* lower, const Columns& columns, std::uint8_t* cb,
                   std::uint8_t* cr) {
  const SplitWeights blue = split(kCb), red = split(kCr);
  const __m128i offset = _mm_set1_epi32(kChromaOffset);
  const int end = vectorEnd<kChannels>(columns, 8);
  const int left = std::max(columns.from - 1, 0) * kChannels;  // column 0 replaces column -1
  __m128i before = pixelSum(upper + left, lower + left);
  for (int x = columns.from; x < end; x += 8) {
    const RowSums v = rowSums<kChannels>(upper + pixelAt(x, kChannels), lower + pixelAt(x, kChannels));
    const __m128i s01 = _mm_unpacklo_epi64(weighed121(before, v.p01), weighed121(v.p01, v.p23));
    const __m128i s23 = _mm_unpacklo_epi64(weighed121(v.p23, v.p45), weighed121(v.p45, v.p67));
    before = v.p67;
    store4(cb + x / 2, weighed(blue, s01, s23, offset));
    store4(cr + x / 2, weighed(red, s01, s23, offset));
  }
  chromaRow(upper, lower, kChannels, end / 2, columns.to / 2, cb, cr);
}

template <int kChannels>
void convertFast(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part) {
  const Columns columns{part.left, part.right, picture.size.width};
  for (int y = part.top; y < part.bottom; y += 2) {
    const std::uint8_t *upper = picture.at(0, y), *lower = picture.at(0, y + 1);
    fastLumaRow<kChannels>(upper, columns, planes.y + y * planes.yStride);
    fastLumaRow<kChannels>(lower, columns, planes.y + (y + 1) * planes.yStride);
    fastChromaRow<kChannels>(upper, lower, columns, planes.cb + y / 2 * planes.cbStride,
                             planes.cr + y / 2 * planes.crStride);
  }
}
#endif

void checkShape(const image::Image& picture) {
  POINSOT_EXPECT(picture.size.width > 0 && picture.size.width % 2 == 0);
  POINSOT_EXPECT(picture.size.height > 0 && picture.size.height % 2 == 0);
}

/// Returns the blocks of eight columns and two rows that change if a part of the picture changes. The chroma
/// sample to the right of the part changes too, because it depends on the part's last column.
image::PixelRect blocksWith(const image::PixelRect& part, image::PixelSize size) {
  POINSOT_EXPECT(part.left >= 0 && part.top >= 0 && part.right <= size.width && part.bottom <= size.height);
  return {part.left / 8 * 8, part.top / 2 * 2, std::min((part.right + 2 + 7) / 8 * 8, size.width),
          std::min((part.bottom + 1) / 2 * 2, size.height)};
}

void convertScalar(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part) {
  for (int y = part.top; y < part.bottom; y += 2) {
    const std::uint8_t *upper = picture.at(0, y), *lower = picture.at(0, y + 1);
    lumaRow(upper, picture.channels, part.left, part.right, planes.y + y * planes.yStride);
    lumaRow(lower, picture.channels, part.left, part.right, planes.y + (y + 1) * planes.yStride);
    chromaRow(upper, lower, picture.channels, part.left / 2, part.right / 2, planes.cb + y / 2 * planes.cbStride,
              planes.cr + y / 2 * planes.crStride);
  }
}

}  // namespace

void convertToYuv420Scalar(const image::Image& picture, const YuvPlanes& planes) {
  checkShape(picture);
  convertScalar(picture, planes, wholeOf(picture.size));
}

void convertToYuv420(const image::Image& picture, const YuvPlanes& planes) {
  convertPartToYuv420(picture, planes, wholeOf(picture.size));
}

void convertPartToYuv420(const image::Image& picture, const YuvPlanes& planes, const image::PixelRect& part) {
  checkShape(picture);
  if (part.empty()) return;
  const image::PixelRect blocks = blocksWith(part, picture.size);
#if defined(__SSE2__)
  if (picture.channels == 4) return convertFast<4>(picture, planes, blocks);
  return convertFast<3>(picture, planes, blocks);
#else
  convertScalar(picture, planes, blocks);
#endif
}

}  // namespace poinsot::output
