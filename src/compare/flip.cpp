// SPDX-License-Identifier: Apache-2.0
// FLIP for pictures of low dynamic range. A pixel's error combines a colour error and a feature error. Both are
// computed from a sliding window of rows in the linear opponent space Y Cx Cz. For the colour error, rows are
// blurred with the eye's contrast sensitivity, converted to linear RGB, and compared in Hunt-adjusted CIELab. For
// the feature error, edges and points are detected in the unblurred luminance. Pixels that no filter connects with
// a differing pixel have the error 0 and are not computed.
#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "compare/affected_spans.h"
#include "compare/flip_color.h"
#include "compare/flip_stages.h"
#include "compare/row_arithmetic.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::compare {
namespace {

template <typename Sample>
const std::vector<double>& linearTable() {
  static const std::vector<double> table = [] {
    constexpr std::size_t kMost = image::BasicImage<Sample>::kMost;
    std::vector<double> values(kMost + 1);
    for (std::size_t v = 0; v <= kMost; ++v) values[v] = linearLight(static_cast<double>(v) / kMost);
    return values;
  }();
  return table;
}

enum Plane { kY, kCx, kCz, kPlanes };

template <typename Sample>
RowWindow opponentWindow(const image::BasicImage<Sample>& picture, int radius) {
  return {picture.size, kPlanes, radius, [&picture](int y, const std::vector<double*>& planes) {
            const auto& linear = linearTable<Sample>();
            const Sample* p = picture.at(0, y);
            for (int x = 0; x < picture.size.width; ++x, p += picture.channels) {
              const Triple color = opponentColor({linear[p[0]], linear[p[1]], linear[p[2]]});
              for (std::size_t k = 0; k < kPlanes; ++k) planes[k][x] = color[k];
            }
          }};
}

/// Perceived rows of a picture, from the top.
class PerceivedRows {
 public:
  template <typename Sample>
  PerceivedRows(const image::BasicImage<Sample>& picture, double pixelsPerDegree)
      : window_(opponentWindow(picture, flipRadius(pixelsPerDegree))),
        sensitivity_(contrastSensitivity(pixelsPerDegree)),
        features_(featureKernels(pixelsPerDegree)) {}

  /// Computes row y in some spans of columns. @pre as RowWindow::moveTo()
  void moveTo(int y, const std::vector<ColumnSpan>& spans) {
    window_.moveTo(y);
    for (const ColumnSpan& span : spans) {
      for (int plane = 0; plane < kPlanes; ++plane) blur(plane, span);
      toHuntLab({color_[kY].columns(), color_[kCx].columns(), color_[kCz].columns()}, span);
      findFeatures(span);
    }
  }

  PerceivedRow row() const {
    return {
        {color_[kY].columns(), color_[kCx].columns(), color_[kCz].columns()}, edge_.columns(), point_.columns()};
  }

 private:
  void blur(int plane, ColumnSpan span) {
    double* const out = color_[static_cast<std::size_t>(plane)].columns();
    std::fill(out + span.begin, out + span.end, 0.0);
    for (const SensitivityPart& part : sensitivity_[static_cast<std::size_t>(plane)]) {
      filter(part.profile, part.profile, plane, span, across_);
      addScaled(across_.columns(), part.weight, span, out);
    }
  }

  /// Computes the strengths of edges and points. Each strength is the length of a gradient, whose components are
  /// filter responses along x and along y. Each response is smoothed in the other direction.
  void findFeatures(ColumnSpan span) {
    features_.smooth.alongColumns(window_, kY, span.grown(window_.radius()), smoothed_.columns());
    findFeature(features_.edge, span, edge_);
    findFeature(features_.point, span, point_);
  }

  void findFeature(const Kernel& profile, ColumnSpan span, MarginedRow& length) {
    // Luminance is (Y + 16) / 116. The 16 cancels, because the weights of a profile sum to 0.
    constexpr double kScale = 116;
    profile.alongRow(smoothed_.columns(), span, length.columns());
    filter(profile, features_.smooth, kY, span, across_);
    toLengths(length.columns(), across_.columns(), kScale, span);
  }

  void filter(const Kernel& alongY, const Kernel& alongX, int plane, ColumnSpan span, MarginedRow& out) {
    alongY.alongColumns(window_, plane, span.grown(alongX.radius()), column_.columns());
    alongX.alongRow(column_.columns(), span, out.columns());
  }

  RowWindow window_;
  std::array<std::vector<SensitivityPart>, kPlanes> sensitivity_;
  FeatureKernels features_;
  const MarginedRow empty_{window_.width(), window_.radius()};
  MarginedRow column_ = empty_, smoothed_ = empty_, across_ = empty_, edge_ = empty_, point_ = empty_;
  std::array<MarginedRow, kPlanes> color_{empty_, empty_, empty_};
};

template <typename Sample>
FlipMap flipOf(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, double pixelsPerDegree) {
  POINSOT_EXPECT(a.size == b.size && !a.pixels.empty() && pixelsPerDegree > 0);
  const auto width = static_cast<std::size_t>(a.size.width);
  FlipMap map{a.size, std::vector<double>(width * static_cast<std::size_t>(a.size.height))};
  AffectedSpans affected(a, b, flipRadius(pixelsPerDegree));
  PerceivedRows rowsA(a, pixelsPerDegree), rowsB(b, pixelsPerDegree);
  double* errors = map.error.data();
  for (int y = 0; y < a.size.height; ++y, errors += width) {
    const std::vector<ColumnSpan>& spans = affected.row(y);
    if (spans.empty()) continue;
    rowsA.moveTo(y, spans);
    rowsB.moveTo(y, spans);
    for (const ColumnSpan& span : spans) flipErrors(rowsA.row(), rowsB.row(), span, errors);
  }
  return map;
}

/// Quantiles weighted by value. at(share) returns the smallest value at which the running sum of the sorted values
/// exceeds `share` times the total. Only the values near a quantile are sorted: bins divide the values by size.
class WeightedQuantiles {
 public:
  explicit WeightedQuantiles(const std::vector<double>& values) : values_(values) {
    forEachValue([this](double value) {
      bins_[binOf(value)] += value;
      total_ += value;
    });
  }

  double at(double share) const {
    double sum = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (sum + bins_[bin] > share * total_) return within(bin, sum, share * total_);
      sum += bins_[bin];
    }
    return 0;
  }

 private:
  static constexpr std::size_t kBins = 1024;

  static std::size_t binOf(double value) { return std::min(static_cast<std::size_t>(value * kBins), kBins - 1); }

  template <typename Visit>
  void forEachValue(Visit visit) const {
    constexpr std::size_t kCheckedAtOnce = 1 << 16;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (i % kCheckedAtOnce == 0) core::checkInterruption();
      visit(values_[i]);
    }
  }

  double within(std::size_t bin, double sum, double wanted) const {
    std::vector<double> sorted;
    forEachValue([&](double value) {
      if (binOf(value) == bin) sorted.push_back(value);
    });
    std::sort(sorted.begin(), sorted.end());
    for (const double value : sorted)
      if ((sum += value) > wanted) return value;
    return sorted.back();
  }

  const std::vector<double>& values_;
  std::array<double, kBins> bins_{};  ///< sum of the values in each bin
  double total_ = 0;
};

}  // namespace

double FlipMap::mean() const {
  return std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size());
}

double FlipMap::max() const { return *std::max_element(error.begin(), error.end()); }

FlipFigures figuresOf(const FlipMap& map, std::optional<std::int64_t> pixels) {
  const WeightedQuantiles quantiles(map.error);
  const auto all = static_cast<double>(map.error.size());
  const double mean = pixels && *pixels > 0 ? map.mean() * (all / static_cast<double>(*pixels)) : map.mean();
  return {mean,
          *std::min_element(map.error.begin(), map.error.end()),
          quantiles.at(0.25),
          quantiles.at(0.5),
          quantiles.at(0.75),
          map.max()};
}

FlipMap flip(const image::Image& a, const image::Image& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

FlipMap flip(const image::DeepImage& a, const image::DeepImage& b, double pixelsPerDegree) {
  return flipOf(a, b, pixelsPerDegree);
}

}  // namespace poinsot::compare
