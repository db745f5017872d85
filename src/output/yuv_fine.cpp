// SPDX-License-Identifier: Apache-2.0
// Conversions that only a few films need, as simple loops. yuv.cpp has the conversion of most films.
#include <array>

#include "core/expect.h"
#include "output/yuv.h"
#include "output/yuv_weights.h"

namespace poinsot::output {
namespace {

// Scale of the integer weights: the largest sum of a 10-bit sample, 940 · 2^20, fits 31 bits.
constexpr int kFineShift = 20;
constexpr double kScale = 1 << kFineShift;
constexpr std::int32_t kFineHalf = 1 << (kFineShift - 1);

struct Basis {
  explicit constexpr Basis(int bits)
      : levels(1 << (bits - 8)),
        luma(lumaWeights(kScale * levels)),
        cb(cbWeights(kScale * levels)),
        cr(crWeights(kScale * levels)) {}

  std::int32_t levels;  ///< steps of a sample in one step of a byte: 1 or 4
  Weights luma, cb, cr;
};

std::int32_t weighed(const Weights& w, const std::uint8_t* rgb, std::int32_t zero) {
  return (w.r * rgb[0] + w.g * rgb[1] + w.b * rgb[2] + (zero << kFineShift) + kFineHalf) >> kFineShift;
}

template <class Sample>
Sample* row(std::uint8_t* plane, std::ptrdiff_t stride, int y) {
  return reinterpret_cast<Sample*>(plane + y * stride);
}

/// Scales a byte of alpha to the full range of a sample.
template <int kBits>
std::int32_t widened(std::int32_t alpha) {
  return (alpha * ((1 << kBits) - 1) + 127) / 255;
}

template <class Sample, int kBits>
void fill444(const image::Image& picture, const YuvPlanes& planes) {
  static constexpr Basis kBasis(kBits);
  for (int y = 0; y < picture.size.height; ++y) {
    const std::uint8_t* from = picture.at(0, y);
    auto* luma = row<Sample>(planes.y, planes.yStride, y);
    auto* cb = row<Sample>(planes.cb, planes.cbStride, y);
    auto* cr = row<Sample>(planes.cr, planes.crStride, y);
    auto* alpha = planes.alpha ? row<Sample>(planes.alpha, planes.alphaStride, y) : nullptr;
    for (int x = 0; x < picture.size.width; ++x, from += picture.channels) {
      luma[x] = static_cast<Sample>(weighed(kBasis.luma, from, 16 * kBasis.levels));
      cb[x] = static_cast<Sample>(weighed(kBasis.cb, from, 128 * kBasis.levels));
      cr[x] = static_cast<Sample>(weighed(kBasis.cr, from, 128 * kBasis.levels));
      if (alpha) alpha[x] = static_cast<Sample>(widened<kBits>(picture.channels == 4 ? from[3] : 255));
    }
  }
}

/// Returns the mean colour of the pixels that belong to one chroma sample, weighted by alpha. The pixels are
/// column 2x and its neighbours, on both rows.
std::array<std::uint8_t, 3> meanUnderAlpha(const image::Image& picture, int x, int y) {
  constexpr std::array<int, 3> kWeights{1, 2, 1};
  std::array<std::int32_t, 3> sum{};
  std::int32_t total = 0;
  for (int dy = 0; dy < 2; ++dy)
    for (int i = 0; i < 3; ++i) {
      const std::uint8_t* p = picture.at(2 * x - 1 + i < 0 ? 0 : 2 * x - 1 + i, 2 * y + dy);
      const std::int32_t weight = kWeights[static_cast<std::size_t>(i)] * p[3];
      total += weight;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * p[c];
    }
  if (total == 0) return {128, 128, 128};
  std::array<std::uint8_t, 3> mean{};
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((sum[c] + total / 2) / total);
  return mean;
}

}  // namespace

void convertToYuv444(const image::Image& picture, const YuvPlanes& planes, int bits) {
  POINSOT_EXPECT(bits == 8 || bits == 10);
  if (bits == 8) return fill444<std::uint8_t, 8>(picture, planes);
  fill444<std::uint16_t, 10>(picture, planes);
}

void convertToYuva420(const image::Image& picture, const YuvPlanes& planes) {
  POINSOT_EXPECT(picture.channels == 4 && picture.size.width % 2 == 0 && picture.size.height % 2 == 0);
  static constexpr Basis kBasis(8);
  for (int y = 0; y < picture.size.height; ++y) {
    const std::uint8_t* from = picture.at(0, y);
    for (int x = 0; x < picture.size.width; ++x, from += 4) {
      planes.y[y * planes.yStride + x] = static_cast<std::uint8_t>(weighed(kBasis.luma, from, 16));
      planes.alpha[y * planes.alphaStride + x] = from[3];
    }
  }
  for (int y = 0; y < picture.size.height / 2; ++y)
    for (int x = 0; x < picture.size.width / 2; ++x) {
      const auto mean = meanUnderAlpha(picture, x, y);
      planes.cb[y * planes.cbStride + x] = static_cast<std::uint8_t>(weighed(kBasis.cb, mean.data(), 128));
      planes.cr[y * planes.crStride + x] = static_cast<std::uint8_t>(weighed(kBasis.cr, mean.data(), 128));
    }
}

}  // namespace poinsot::output
