// SPDX-License-Identifier: Apache-2.0
#include "compare/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/affected_spans.h"
#include "compare/kernel.h"
#include "compare/row_arithmetic.h"
#include "core/expect.h"

namespace poinsot::compare {
namespace {

constexpr int kRadius = 5;

/// Returns a Gaussian along one axis. The products of its weights along both axes sum to 1.
Kernel windowProfile() {
  constexpr double kSigma = 1.5;
  std::vector<double> half;
  for (int i = 0; i <= kRadius; ++i) half.push_back(std::exp(-i * i / (2 * kSigma * kSigma)));
  const Kernel bell(Kernel::Parity::kEven, half);
  return bell.scaled(1 / bell.sum());
}

template <typename Sample>
double luma(const Sample* p) {
  return (0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]) / image::BasicImage<Sample>::kMost;
}

enum Moment { kA, kB, kSquares, kProducts, kMoments };

template <typename Sample>
RowWindow lumaWindow(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b) {
  return {a.size, kMoments, kRadius, [&a, &b](int y, const std::vector<double*>& rows) {
            double* const* const planes = rows.data();  // raw pointers: checked indices take longer than the sum
            const Sample *p = a.at(0, y), *q = b.at(0, y);
            for (int x = 0; x < a.size.width; ++x, p += a.channels, q += b.channels) {
              const double va = luma(p), vb = luma(q);
              planes[kA][x] = va;
              planes[kB][x] = vb;
              planes[kSquares][x] = va * va + vb * vb;
              planes[kProducts][x] = 2 * va * vb;
            }
          }};
}

template <typename Sample>
std::optional<SsimFigures> ssimOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                                  const IgnoreMask* ignored) {
  POINSOT_EXPECT(a.size == b.size);
  const int width = a.size.width, height = a.size.height;
  if (std::min(width, height) < 2 * kRadius + 1) return std::nullopt;
  const Kernel profile = windowProfile();
  RowWindow window = lumaWindow(a, b);
  AffectedSpans affected(a, b, kRadius);
  MarginedRow column(width, kRadius);
  std::array<MarginedRow, kMoments> means{column, column, column, column};
  std::vector<double> row(static_cast<std::size_t>(width));
  SsimFigures figures;
  double sum = 0;
  std::int64_t windows = 0;
  for (int y = kRadius; y < height - kRadius; ++y) {
    const std::vector<ColumnSpan>& spans = affected.row(y);
    std::ranges::fill(row, 1.0);  // equal windows have the similarity 1
    if (!spans.empty()) window.moveTo(y);
    for (const ColumnSpan& span : spans) {
      for (int k = 0; k < kMoments; ++k) {
        profile.alongColumns(window, k, span.grown(kRadius), column.columns());
        profile.alongRow(column.columns(), span, means[static_cast<std::size_t>(k)].columns());
      }
      similarities(
          {means[kA].columns(), means[kB].columns(), means[kSquares].columns(), means[kProducts].columns()}, span,
          row.data());
    }
    for (int x = kRadius; x < width - kRadius; ++x) {
      if (ignored && ignored->ignores(x, y)) continue;
      const double s = row[static_cast<std::size_t>(x)];
      sum += s;
      ++windows;
      if (s < figures.worst) figures = {0, s, x, y};
    }
  }
  if (windows == 0) return std::nullopt;
  figures.mean = sum / static_cast<double>(windows);
  return figures;
}

}  // namespace

std::optional<SsimFigures> ssim(const image::Image& a, const image::Image& b, const IgnoreMask* ignored) {
  return ssimOf(a, b, ignored);
}
std::optional<SsimFigures> ssim(const image::DeepImage& a, const image::DeepImage& b, const IgnoreMask* ignored) {
  return ssimOf(a, b, ignored);
}

}  // namespace poinsot::compare
